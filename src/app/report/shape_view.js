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

/** When a curve's samples were: evenly apart, or two in each stretch of time at the places that their bytes name. */
function sampleTimes(series, places) {
  return Array.from({ length: series.count }, (_, i) => series.bucket === undefined
    ? series.begin + i * series.step : series.begin + ((i >> 1) + places[i] / 255) * series.bucket);
}

/** What a job's run says, unpacked: path, phases, forces, curves, and of each stretch of time what share of it slips and sticks and how
 *  often stick gives way in it. */
function unpackedRun(run) {
  const bytes = bytesOf(run.data);
  const n = run.path.count, m = run.series.count, shares = run.series.shares, curves = run.series.curves, names = run.series.bytes;
  const words = new Uint16Array(bytes.buffer, 0, 3 * n + m * curves.length);
  const rest = bytes.subarray(2 * words.length), places = rest.subarray(2 * n + names.length * shares);
  return {
    path: words.subarray(0, 3 * n), forces: rest.subarray(0, n), phases: rest.subarray(n, 2 * n),
    span: [run.series.begin, run.series.begin + run.series.step * (run.series.bucket > 0 ? shares : shares - 1)],
    curves: curves.map((curve, c) => ({ name: curve.name, unit: curve.unit, inPairs: run.series.bucket > 0,
      times: sampleTimes(run.series, places.subarray(c * m, (c + 1) * m)),
      values: unpacked(words.subarray(3 * n + c * m, 3 * n + (c + 1) * m), curve.low, curve.span) })),
    shares: { begin: run.series.begin, step: run.series.step, count: shares, ...Object.fromEntries(names.map((name, i) =>
      [name, rest.subarray(2 * n + i * shares, 2 * n + (i + 1) * shares)])) }
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
    this.shapePoints = points;
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
    this.pathPoints = points;
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

  /** How far off the eye has to be, in its direction from the target, so that all points are in sight. */
  distanceToSee(points, target, eye, up) {
    const across = new THREE.Vector3().crossVectors(up, eye), at = new THREE.Vector3();
    const slope = Math.tan(this.camera.fov / 2 * Math.PI / 180);
    let distance = 0;
    for (let i = 0; i < points.length; i += 3) {
      at.set(points[i], points[i + 1], points[i + 2]).sub(target);
      distance = Math.max(distance, at.dot(eye) + Math.max(Math.abs(at.dot(up)), Math.abs(at.dot(across)) / this.camera.aspect) / slope);
    }
    return Math.max(1.06 * distance, this.radius / 50);
  }

  /** From the contact's side: the path with as much of the part about it; else, and where that is nearly all, the whole part. */
  lookFrom(name) {
    const named = { top: [[0, 0, 1], [0, 1, 0]], front: [[0, -1, 0], [0, 0, 1]], right: [[1, 0, 0], [0, 0, 1]],
      contact: [this.run.look.eye, this.run.look.up], whole: [this.run.look.eye, this.run.look.up] };
    const [eye, up] = named[name].map(axes => new THREE.Vector3(...axes));
    const whole = this.shapePoints || this.pathPoints;
    let target = new THREE.Vector3(), distance = this.distanceToSee(whole, target, eye, up);
    if (name === "contact") {
      const box = new THREE.Box3().setFromArray(this.pathPoints), middle = box.getCenter(new THREE.Vector3());
      const near = Math.max(4 * this.distanceToSee(this.pathPoints, middle, eye, up), 0.35 * distance);
      if (near < 0.8 * distance) [target, distance] = [middle, near];
    }
    this.camera.up.copy(up);
    this.controls.dispose();
    this.camera.position.copy(target).addScaledVector(eye, distance);
    this.controls = new THREE.OrbitControls(this.camera, this.renderer.domElement);
    this.controls.target.copy(target);
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
