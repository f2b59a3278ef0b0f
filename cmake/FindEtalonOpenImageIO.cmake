# OpenImageIO by its header and its libraries, as Etalon::OpenImageIO. The configuration that Debian
# 12 and 13 install with it stops with an error unless the package's programs are there too, and
# its target names /usr/include/opencv4, which no dependency brings.
find_path(OpenImageIO_INCLUDE_DIR OpenImageIO/imageio.h)
find_library(OpenImageIO_LIBRARY OpenImageIO)
find_library(OpenImageIO_Util_LIBRARY OpenImageIO_Util)
mark_as_advanced(OpenImageIO_INCLUDE_DIR OpenImageIO_LIBRARY OpenImageIO_Util_LIBRARY)

if(OpenImageIO_INCLUDE_DIR)
  file(STRINGS ${OpenImageIO_INCLUDE_DIR}/OpenImageIO/oiioversion.h lines
    REGEX "^#define OIIO_VERSION_(MAJOR|MINOR|PATCH) ")
  string(REGEX REPLACE "[^0-9;]" "" numbers "${lines}")
  string(REPLACE ";" "." EtalonOpenImageIO_VERSION "${numbers}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(EtalonOpenImageIO
  REQUIRED_VARS OpenImageIO_LIBRARY OpenImageIO_Util_LIBRARY OpenImageIO_INCLUDE_DIR
  VERSION_VAR EtalonOpenImageIO_VERSION
  REASON_FAILURE_MESSAGE "Debian's package is libopenimageio-dev.")

if(EtalonOpenImageIO_FOUND AND NOT TARGET Etalon::OpenImageIO)
  add_library(Etalon::OpenImageIO INTERFACE IMPORTED)
  target_include_directories(Etalon::OpenImageIO INTERFACE ${OpenImageIO_INCLUDE_DIR})
  target_link_libraries(Etalon::OpenImageIO INTERFACE
    ${OpenImageIO_LIBRARY} ${OpenImageIO_Util_LIBRARY} Imath::Imath)
endif()
