include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY FULBITO_LIBRARIES)
install(TARGETS ${libraries} EXPORT fulbitoTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS fulbito RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
foreach(folder engine/core engine/sim navigation referee replays/render experiments)
  install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fulbito/${folder} FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(EXPORT fulbitoTargets NAMESPACE fulbito:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/fulbito)
configure_package_config_file(cmake/fulbitoConfig.cmake.in ${PROJECT_BINARY_DIR}/fulbitoConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/fulbito)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/fulbitoConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/fulbitoConfig.cmake ${PROJECT_BINARY_DIR}/fulbitoConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/fulbito)
