# find_package(Etalon CONFIG): the libraries of Etalon as targets etalon::<name>.
include(CMakeFindDependencyMacro)

# Debian's Imath reports as a status, when it is found first, that its module for Python is missing, which
# nothing here uses.
function(etalon_find_imath_quietly)
  set(CMAKE_MESSAGE_LOG_LEVEL NOTICE) # here only
  find_package(Imath 3 CONFIG QUIET)
endfunction()
etalon_find_imath_quietly()

list(PREPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
include(${CMAKE_CURRENT_LIST_DIR}/EtalonDependencies.cmake)
foreach(dependency IN LISTS ETALON_DEPENDENCIES)
  separate_arguments(dependency)
  find_dependency(${dependency})
endforeach()
list(POP_FRONT CMAKE_MODULE_PATH)

include(${CMAKE_CURRENT_LIST_DIR}/EtalonTargets.cmake)
