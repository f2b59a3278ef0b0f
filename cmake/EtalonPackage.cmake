# cpack -G DEB: the packages etalon, etalon-mpi and libetalon-dev, for the Debian on which they are built. What
# etalon depends on is read from its programs, so the versions of libraries are those of that Debian.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL programs development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The Etalon contributors <etalon@localhost>")
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)

# Packages for two releases of Debian have different names.
if(EXISTS /etc/os-release)
  file(STRINGS /etc/os-release lines REGEX "^(ID|VERSION_ID)=")
  string(REGEX REPLACE "(VERSION_)?ID=|\"" "" lines "${lines}")
  list(SORT lines ORDER DESCENDING) # the name, then the number
  list(JOIN lines "" CPACK_DEBIAN_PACKAGE_RELEASE)
  string(PREPEND CPACK_DEBIAN_PACKAGE_RELEASE "1~")
endif()

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME etalon)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_PROGRAMS_DESCRIPTION 
  "Programs that render scenes with exchangeable accelerators, and measure how fast and how accurate they are.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libetalon-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
list(JOIN ETALON_DEBIAN_PACKAGES ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
# Programs that link the libraries need a module of it to read images of rarer formats.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS etalon)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION 
  "Static libraries, headers and the configuration for CMake, for those who write a backend or a loader.")

# Who renders in one process need not install Open MPI.
if(TARGET etalon_mpi)
  list(INSERT CPACK_COMPONENTS_ALL 1 mpi)
  set(CPACK_DEBIAN_MPI_PACKAGE_NAME etalon-mpi)
  set(CPACK_DEBIAN_MPI_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS
    "etalon (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}), openmpi-bin")
  set(CPACK_COMPONENT_MPI_DESCRIPTION
    "The module by which etalon renders one image with many processes, on many machines.")
endif()

include(CPack)
