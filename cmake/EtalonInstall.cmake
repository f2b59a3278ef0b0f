# What cmake --install copies, in components: `programs`, for who renders and measures, `mpi`, for who
# does so with MPI, and `development`, for who writes a backend or a loader in a project of their own.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The programs look for their module in ../lib/etalon, so this is "lib" on every system.
set(ETALON_INSTALL_LIBDIR lib/etalon)
set(ETALON_INSTALL_CMAKEDIR lib/cmake/Etalon)
set(ETALON_INSTALL_INCLUDEDIR ${CMAKE_INSTALL_INCLUDEDIR}/etalon)

# What must be built for that: not the tests.
add_custom_target(installable)

# etalon_install_library(<target> <name>) installs a library, known as etalon::<name>.
function(etalon_install_library target name)
  add_dependencies(installable ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS ${target} EXPORT EtalonTargets
    ARCHIVE DESTINATION ${ETALON_INSTALL_LIBDIR} COMPONENT development)
endfunction()

# etalon_install_program(<target>) installs a program, and what it says of itself: it writes its
# manual pages and the completion of its command line from the options that it declares.
function(etalon_install_program target)
  add_dependencies(installable ${target})
  install(TARGETS ${target} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs)
  set(folder ${PROJECT_BINARY_DIR}/documentation/${target})
  install(CODE "
    file(REMOVE_RECURSE \"${folder}\")
    execute_process(COMMAND \"$<TARGET_FILE:${target}>\" --write-documentation \"${folder}\"
      COMMAND_ERROR_IS_FATAL ANY)"
    COMPONENT programs)
  install(DIRECTORY ${folder}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT programs)
  install(DIRECTORY ${folder}/completions/bash/
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT programs)
  install(DIRECTORY ${folder}/completions/fish/
    DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT programs)
  # Debian's zsh looks for the functions of packages elsewhere than for those of /usr/local.
  install(CODE "
    set(place site-functions)
    if(CMAKE_INSTALL_PREFIX MATCHES \"/usr$\")
      set(place vendor-completions)
    endif()
    file(INSTALL \"${folder}/completions/zsh/\"
      DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/zsh/\${place}\")"
    COMPONENT programs)
endfunction()

# etalon_install_package() installs the headers and the configuration for find_package(Etalon).
function(etalon_install_package)
  install(DIRECTORY app bench core embree_backend native_accel scenes
    DESTINATION ${ETALON_INSTALL_INCLUDEDIR} COMPONENT development
    FILES_MATCHING PATTERN "*.h"
    PATTERN scenes/features EXCLUDE PATTERN scenes/pbrt EXCLUDE
    PATTERN scenes/skybox EXCLUDE)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/EtalonConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES
    ${PROJECT_SOURCE_DIR}/cmake/EtalonConfig.cmake
    ${PROJECT_SOURCE_DIR}/cmake/EtalonDependencies.cmake
    ${PROJECT_SOURCE_DIR}/cmake/FindEtalonDeflate.cmake
    ${PROJECT_BINARY_DIR}/EtalonConfigVersion.cmake
    DESTINATION ${ETALON_INSTALL_CMAKEDIR} COMPONENT development)
  install(EXPORT EtalonTargets NAMESPACE etalon::
    DESTINATION ${ETALON_INSTALL_CMAKEDIR} COMPONENT development)
  # What etalon-bench report renders.
  install(DIRECTORY scenes/features scenes/pbrt scenes/skybox
    DESTINATION ${CMAKE_INSTALL_DATADIR}/etalon/scenes COMPONENT programs
    PATTERN "*.py" EXCLUDE)
  install(FILES scenes/showcase.p3f
    DESTINATION ${CMAKE_INSTALL_DATADIR}/etalon/scenes COMPONENT programs)
  # What help texts and manual pages refer to; links between these files hold there, too.
  install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/etalon COMPONENT programs)
  install(PROGRAMS scripts/slurm/submit scripts/slurm/task
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/etalon/scripts/slurm COMPONENT programs)
  install(FILES README.md SECURITY.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/etalon
    COMPONENT programs)
  # Debian requires one of each package.
  foreach(package programs:etalon mpi:etalon-mpi development:libetalon-dev)
    string(REPLACE ":" ";" package ${package})
    list(GET package 0 component)
    list(GET package 1 name)
    if(component STREQUAL mpi AND NOT TARGET etalon_mpi)
      continue()
    endif()
    install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} RENAME copyright
      COMPONENT ${component})
  endforeach()
endfunction()
