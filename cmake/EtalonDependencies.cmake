# Packages that the libraries of Etalon link, one list for the build and for find_package(Etalon).
# Each entry is what find_package takes. Debian 12 and 13 have them all.
set(ETALON_DEPENDENCIES
  "Imath 3 CONFIG"
  "TBB CONFIG"
  "OpenEXR 3 CONFIG"
  "hwy 1 CONFIG"   # Highway
  "embree CONFIG"  # 3.12 to 4.x: the version decides the header
  "fmt CONFIG"
  "CLI11 CONFIG"
  "nlohmann_json CONFIG"
  "JPEG"           # libjpeg-turbo
  "PNG 1.6"
  "EtalonDeflate") # FindEtalonDeflate.cmake beside this file

# Debian's packages of them.
set(ETALON_DEBIAN_PACKAGES
  libimath-dev libtbb-dev libopenexr-dev libhwy-dev libembree-dev libfmt-dev libcli11-dev
  nlohmann-json3-dev libjpeg-dev libpng-dev libdeflate-dev)
