# Install rules and the CMake package: find_package(cairn COMPONENTS physics engine scripting). Each component has an
# export set of its own, so that whoever asks for the physics alone needs neither SDL nor Lua.
include(CMakePackageConfigHelpers)

set(cairn_components physics)
if(CAIRN_ENGINE)
  list(APPEND cairn_components engine)
endif()
if(CAIRN_SCRIPTING)
  list(APPEND cairn_components scripting)
endif()

set(cairn_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/cairn)
foreach(component IN LISTS cairn_components)
  install(TARGETS cairn_${component} EXPORT cairn-${component}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
          FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT cairn-${component} NAMESPACE cairn:: DESTINATION ${cairn_package_dir})
endforeach()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/cairn-config.cmake.in
                              ${CMAKE_CURRENT_BINARY_DIR}/cairn-config.cmake
                              INSTALL_DESTINATION ${cairn_package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/cairn-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/cairn-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/cairn-config-version.cmake
        DESTINATION ${cairn_package_dir})
