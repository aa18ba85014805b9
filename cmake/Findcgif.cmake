# cgif, which writes GIF files, as the target cgif::cgif: distributions ship it without a package of CMake.
find_path(CGIF_INCLUDE_DIR cgif.h)
find_library(CGIF_LIBRARY cgif)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(cgif REQUIRED_VARS CGIF_LIBRARY CGIF_INCLUDE_DIR)
if(cgif_FOUND AND NOT TARGET cgif::cgif)
  add_library(cgif::cgif UNKNOWN IMPORTED)
  set_target_properties(cgif::cgif PROPERTIES
    IMPORTED_LOCATION "${CGIF_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${CGIF_INCLUDE_DIR}")
endif()
mark_as_advanced(CGIF_INCLUDE_DIR CGIF_LIBRARY)
