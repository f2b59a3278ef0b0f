# libdeflate by its header and its library, as Etalon::Deflate. Debian 12's package has no
# configuration for CMake.
find_path(Deflate_INCLUDE_DIR libdeflate.h)
find_library(Deflate_LIBRARY deflate)
mark_as_advanced(Deflate_INCLUDE_DIR Deflate_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(EtalonDeflate
  REQUIRED_VARS Deflate_LIBRARY Deflate_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "Debian's package is libdeflate-dev.")

if(EtalonDeflate_FOUND AND NOT TARGET Etalon::Deflate)
  add_library(Etalon::Deflate INTERFACE IMPORTED)
  target_include_directories(Etalon::Deflate INTERFACE ${Deflate_INCLUDE_DIR})
  target_link_libraries(Etalon::Deflate INTERFACE ${Deflate_LIBRARY})
endif()
