/** Numbers of 16 bits between low and low + span; 65535 is none. */
function unpacked(codes, low, span) {
  return Array.from(codes, code => code === 65535 ? NaN : low + code / 65534 * span);
}

function unpackedPoints(codes, box, about) {
  const points = new Float32Array(codes.length);
  for (let i = 0; i < codes.length; ++i)
    points[i] = (box.low[i % 3] - about[i % 3] + codes[i] / 65534 * box.span[i % 3]) * 1e3;
  return points;
}

/** What a job's run says, unpacked: path, phases, forces, curves. */
function unpackedRun(run) {
  const bytes = bytesOf(run.data);
  const n = run.path.count, m = run.series.count, curves = run.series.curves;
  const words = new Uint16Array(bytes.buffer, 0, 3 * n + m * curves.length);
  const rest = bytes.subarray(2 * words.length);
  return {
    path: words.subarray(0, 3 * n), forces: rest.subarray(0, n), phases: rest.subarray(n, 2 * n),
    times: Array.from({ length: m }, (_, i) => run.series.begin + i * run.series.step),
    curves: curves.map((curve, c) => ({ name: curve.name, unit: curve.unit,
      values: unpacked(words.subarray(3 * n + c * m, 3 * n + (c + 1) * m), curve.low, curve.span) })),
    seriesPhases: rest.subarray(2 * n, 2 * n + m)
  };
}

let shapeView = null;  // one at a time: a browser has few WebGL contexts

/** The part with the path over it, to be turned by the mouse. */
class ShapeView {
  constructor(run, unpackedData, holder) {
    this.run = run;
    this.data = unpackedData;
    const shape = run.shape >= 0 ? report.shapes[run.shape] : null;
    const box = shape || run.path;
    this.about = box.low.map((low, axis) => low + box.span[axis] / 2);
    this.size = box.span.map(span => span * 1e3);
    this.radius = Math.max(Math.hypot(...this.size) / 2, 1e-3);
    this.renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.autoClear = false;
    this.renderer.setClearColor(0xffffff);
    this.scene = new THREE.Scene();
    this.front = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(35, 1, this.radius / 100, this.radius * 40);
    this.scene.add(new THREE.AmbientLight(0xffffff, 0.45));
    const lamp = new THREE.DirectionalLight(0xffffff, 0.65);
    lamp.position.set(0.5, 0.6, 1);
    this.camera.add(lamp);
    this.scene.add(this.camera);
    if (shape) this.addShape(shape);
    this.colouring = "force";
    this.addPath();
    this.holder = holder;
    holder.append(this.renderer.domElement);
    this.renderer.domElement.setAttribute("aria-label", "3-D view: drag to turn, wheel for nearer, right button to move");
    this.controls = new THREE.OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener("change", () => this.draw());
    this.resize();
    this.lookFrom("contact");
  }

  addShape(shape) {
    const bytes = bytesOf(shape.data);
    const words = new Uint16Array(bytes.buffer);
    const geometry = new THREE.BufferGeometry();
    const points = unpackedPoints(words.subarray(0, 3 * shape.points), shape, this.about);
    geometry.setAttribute("position", new THREE.BufferAttribute(points, 3));
    geometry.setIndex(new THREE.BufferAttribute(words.slice(3 * shape.points), 1));
    const material = new THREE.MeshLambertMaterial({ color: 0xc4ccd4, side: THREE.DoubleSide, flatShading: true,
      polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2 });
    material.flatShading = true;
    const faceted = geometry.toNonIndexed();
    faceted.computeVertexNormals();
    this.scene.add(new THREE.Mesh(faceted, material));
  }

  colourOf(i) {
    const { palette, ramp, phases } = report.colours;
    if (this.colouring === "phase") return new THREE.Color(phases[this.data.phases[i]]);
    return new THREE.Color(ramp[Math.round(this.data.forces[i] / 255 * (ramp.length - 1))]);
  }

  /** Once where it is in sight, once faintly where the part's few triangles hide it. */
  addPath() {
    const points = unpackedPoints(this.data.path, this.run.path, this.about);
    const places = [], colours = [];
    for (let i = 1; i < this.run.path.count; ++i) {
      const colour = this.colourOf(i);
      for (const k of [i - 1, i]) {
        places.push(points[3 * k], points[3 * k + 1], points[3 * k + 2]);
        colours.push(colour.r, colour.g, colour.b);
      }
    }
    this.front.remove(...this.front.children);
    if (places.length === 0) return;
    const geometry = new THREE.LineSegmentsGeometry();
    geometry.setPositions(places);
    geometry.setColors(colours);
    for (const [opacity, hidden] of [[0.3, true], [1, false]]) {
      const material = new THREE.LineMaterial({ color: 0xffffff, linewidth: 3, vertexColors: THREE.VertexColors,
        depthTest: !hidden, transparent: hidden, opacity });
      const line = new THREE.LineSegments2(geometry, material);
      line.renderOrder = hidden ? 0 : 1;
      this.front.add(line);
    }
  }

  colourBy(colouring) {
    this.colouring = colouring;
    this.addPath();
    this.draw();
  }

  lookFrom(name) {
    const named = { top: [[0, 0, 1], [0, 1, 0]], front: [[0, -1, 0], [0, 0, 1]], right: [[1, 0, 0], [0, 0, 1]],
      contact: [this.run.look.eye, this.run.look.up] };
    const [eye, up] = named[name];
    const distance = 1.08 * this.radius / Math.sin(this.camera.fov / 2 * Math.PI / 180);
    this.camera.up.set(...up);
    this.controls.dispose();
    this.camera.position.set(...eye).multiplyScalar(distance);
    this.controls = new THREE.OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener("change", () => this.draw());
    this.controls.update();
    this.draw();
  }

  resize() {
    const width = this.holder.clientWidth, height = this.holder.clientHeight;
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  draw() {
    const width = this.holder.clientWidth, height = this.holder.clientHeight;
    this.front.children.forEach(line => line.material.resolution.set(width, height));
    this.renderer.clear();
    this.renderer.render(this.scene, this.camera);
    this.renderer.render(this.front, this.camera);
  }

  end() {
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.renderer.domElement.remove();
  }
}

window.addEventListener("resize", () => shapeView && shapeView.resize());
