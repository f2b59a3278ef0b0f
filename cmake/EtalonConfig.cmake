# find_package(Etalon CONFIG): the libraries of Etalon as targets etalon::<name>.
include(CMakeFindDependencyMacro)

list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
include(${CMAKE_CURRENT_LIST_DIR}/EtalonDependencies.cmake)
foreach(dependency IN LISTS ETALON_DEPENDENCIES)
  separate_arguments(dependency)
  find_dependency(${dependency})
endforeach()
list(POP_FRONT CMAKE_MODULE_PATH)

include(${CMAKE_CURRENT_LIST_DIR}/EtalonTargets.cmake)
