# A Debian package of what is installed, with scenes, examples and documents: `tools/package` makes it.
set(CPACK_PACKAGE_NAME fingerpad)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "the fingerpad authors <fingerpad@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION "Lets a finger pad touch CAD surfaces: imports a mesh, follows a fingertip over it tick by tick, and answers with
 a normal force and a friction force that sticks and slips as a human finger pad does. A program (touch, replay, view,
 plot, report, study) and a C++20 library.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Pictures without a screen, movies, reports; and what those need who build programs with the library.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS
    "xvfb, xauth, fonts-dejavu-core, libjs-jquery, libjs-jquery-datatables, libjs-dygraphs, libjs-three")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
    "ffmpeg, openmpi-bin, cmake, g++, libeigen3-dev, libfmt-dev, libtbb-dev, libembree-dev, libopenmesh-dev, libtomlplusplus-dev, libhdf5-openmpi-dev, libvtk9-dev")

set(documents ${CMAKE_INSTALL_DATADIR}/doc/fingerpad)
install(DIRECTORY scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/fingerpad COMPONENT package EXCLUDE_FROM_ALL)
install(FILES README.md DESTINATION ${documents} COMPONENT package EXCLUDE_FROM_ALL)
install(FILES LICENSE DESTINATION ${documents} RENAME copyright COMPONENT package EXCLUDE_FROM_ALL)
install(DIRECTORY tools/pictures DESTINATION ${documents}/tools COMPONENT package EXCLUDE_FROM_ALL)
install(PROGRAMS tools/slurm_shards tools/slurm_ranks DESTINATION ${documents}/tools COMPONENT package EXCLUDE_FROM_ALL)
foreach(example touch trace view)
  install(DIRECTORY tests/install/${example} DESTINATION ${documents}/examples COMPONENT package EXCLUDE_FROM_ALL)
endforeach()
# One package of both: what `cmake --install` brings, and what is for the package alone.
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};${PROJECT_NAME};ALL;/"
    "${PROJECT_BINARY_DIR};${PROJECT_NAME};package;/")
include(CPack)
