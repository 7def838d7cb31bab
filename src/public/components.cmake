# What other programs link: three components, each one archive of all the floors that it needs, with the headers of
# src/public/fingerpad and nothing else. What an archive links is told to those who link it, and asked of their
# machine by fingerpadConfig.cmake for the components that they name.
include(CMakePackageConfigHelpers)
set(fingerpad_package ${CMAKE_INSTALL_LIBDIR}/cmake/fingerpad)
set(fingerpad_public ${CMAKE_CURRENT_SOURCE_DIR}/public)

function(fingerpad_component name)
  cmake_parse_arguments(COMPONENT "" "" "SOURCES;FLOORS;PUBLIC;PRIVATE" ${ARGN})
  list(TRANSFORM COMPONENT_SOURCES PREPEND ${fingerpad_public}/)
  set(objects)
  foreach(floor ${COMPONENT_FLOORS})
    list(APPEND objects $<TARGET_OBJECTS:fingerpad_${floor}>)
  endforeach()
  set(target fingerpad_component_${name})
  add_library(${target} STATIC ${COMPONENT_SOURCES} ${objects})
  add_library(fingerpad::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} OUTPUT_NAME fingerpad_${name}
                        ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}
                             PUBLIC $<BUILD_INTERFACE:${fingerpad_public}>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${target} PUBLIC ${COMPONENT_PUBLIC} PRIVATE ${COMPONENT_PRIVATE})
  target_compile_features(${target} INTERFACE cxx_std_20)
  target_compile_definitions(${target} PRIVATE FINGERPAD_VERSION="${PROJECT_VERSION}")
  install(TARGETS ${target} EXPORT fingerpad-${name})
  install(EXPORT fingerpad-${name} NAMESPACE fingerpad:: DESTINATION ${fingerpad_package}
          FILE fingerpad-${name}.cmake)
endfunction()

fingerpad_component(touch SOURCES part_surface.cpp touch_world.cpp finger_scene.cpp finger.cpp
                    FLOORS base part contact friction motion scene touch
                    PUBLIC Eigen3::Eigen
                    PRIVATE fmt::fmt Threads::Threads TBB::tbb tomlplusplus::tomlplusplus ${OPENMESH_CORE_LIBRARY}
                    ${EMBREE_LIBRARY})
# The HDF5 library names the MPI that it needs by itself; only its headers ask for mpi.h.
fingerpad_component(trace SOURCES trace_file.cpp FLOORS trace
                    PUBLIC fingerpad_component_touch PRIVATE fmt::fmt ${HDF5_C_LIBRARIES} ZLIB::ZLIB)
if(FINGERPAD_VIEW)
  fingerpad_component(view SOURCES view.cpp FLOORS view
                      PUBLIC fingerpad_component_trace PRIVATE fmt::fmt ${VTK_LIBRARIES})
endif()

file(GLOB headers CONFIGURE_DEPENDS ${fingerpad_public}/fingerpad/*.hpp)
if(NOT FINGERPAD_VIEW)
  list(FILTER headers EXCLUDE REGEX "/view\\.hpp$")
endif()
install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fingerpad)
configure_package_config_file(${fingerpad_public}/fingerpadConfig.cmake.in fingerpadConfig.cmake
                              INSTALL_DESTINATION ${fingerpad_package})
write_basic_package_version_file(fingerpadConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/fingerpadConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/fingerpadConfigVersion.cmake
        DESTINATION ${fingerpad_package})
