# cpp-httplib as Etalon::Httplib: Debian's package, which is compiled with OpenSSL, zlib and Brotli.
# Its header takes the same definitions. Debian 12's package has no configuration for CMake.
find_path(Httplib_INCLUDE_DIR httplib.h)
find_library(Httplib_LIBRARY cpp-httplib)
mark_as_advanced(Httplib_INCLUDE_DIR Httplib_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(EtalonHttplib
  REQUIRED_VARS Httplib_LIBRARY Httplib_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "Debian's package is libcpp-httplib-dev.")

if(EtalonHttplib_FOUND AND NOT TARGET Etalon::Httplib)
  add_library(Etalon::Httplib INTERFACE IMPORTED)
  target_include_directories(Etalon::Httplib SYSTEM INTERFACE ${Httplib_INCLUDE_DIR})
  target_compile_definitions(Etalon::Httplib INTERFACE
    CPPHTTPLIB_OPENSSL_SUPPORT CPPHTTPLIB_ZLIB_SUPPORT CPPHTTPLIB_BROTLI_SUPPORT)
  target_link_libraries(Etalon::Httplib INTERFACE ${Httplib_LIBRARY})
endif()
