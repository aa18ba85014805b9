include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY FULBITO_LIBRARIES)
install(TARGETS ${libraries} EXPORT fulbitoTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS fulbito RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
# Headers whose first line says that they are private stay behind.
foreach(folder engine navigation strategies referee replays match experiments)
  file(GLOB_RECURSE headers RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.hpp)
  foreach(header IN LISTS headers)
    file(STRINGS ${PROJECT_SOURCE_DIR}/${header} first_line LIMIT_COUNT 1)
    if(NOT first_line MATCHES "^// Private header")
      get_filename_component(place ${header} DIRECTORY)
      install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fulbito/${place})
    endif()
  endforeach()
endforeach()
install(EXPORT fulbitoTargets NAMESPACE fulbito:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/fulbito)
configure_package_config_file(cmake/fulbitoConfig.cmake.in ${PROJECT_BINARY_DIR}/fulbitoConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/fulbito)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/fulbitoConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/fulbitoConfig.cmake ${PROJECT_BINARY_DIR}/fulbitoConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/fulbito)
