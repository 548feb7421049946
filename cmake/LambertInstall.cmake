# `cmake --install` gives the program, the headers and a package for find_package(lambert).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

add_library(lambert INTERFACE)
add_library(lambert::lambert ALIAS lambert)
set(module_targets ${LAMBERT_MODULES})
list(TRANSFORM module_targets PREPEND lambert_)
target_link_libraries(lambert INTERFACE ${module_targets})

install(TARGETS lambert_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS lambert ${module_targets} EXPORT lambert_targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY src/lambert DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(EXPORT lambert_targets NAMESPACE lambert:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/lambert)
configure_package_config_file(cmake/lambert-config.cmake.in ${PROJECT_BINARY_DIR}/lambert-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/lambert)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/lambert-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/lambert-config.cmake ${PROJECT_BINARY_DIR}/lambert-config-version.cmake
  cmake/LambertDependencies.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/lambert)
