include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY FULBITO_LIBRARIES)
# The program links only most of the libraries. With this, `cmake --install` also works after `--target fulbito`.
add_dependencies(fulbito ${libraries})
install(TARGETS ${libraries} EXPORT fulbitoTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS fulbito RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
# The program starts fulbito-team-host for each team of a shared library; users do not call it.
install(TARGETS fulbito-team-host RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/fulbito)
# Installs all headers below sdk/include; every other header is private.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/sdk/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")
# For teams written in Python: users copy it, or add this folder to PYTHONPATH.
install(FILES ${PROJECT_SOURCE_DIR}/sdk/python/fulbito_team.py DESTINATION ${CMAKE_INSTALL_DATADIR}/fulbito/python)
install(EXPORT fulbitoTargets NAMESPACE fulbito:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/fulbito)
# Find modules for libraries without a CMake package.
install(FILES cmake/Findlibdeflate.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/fulbito/modules)
get_property(fulbito_components GLOBAL PROPERTY FULBITO_COMPONENTS)
configure_package_config_file(cmake/fulbitoConfig.cmake.in ${PROJECT_BINARY_DIR}/fulbitoConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/fulbito)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/fulbitoConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/fulbitoConfig.cmake ${PROJECT_BINARY_DIR}/fulbitoConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/fulbito)
