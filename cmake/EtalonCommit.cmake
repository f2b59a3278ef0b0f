# Writes OUTPUT, a source file with the commit of the tree SOURCE, "-dirty" where files differ from it.
# Run by the build whenever Git's log of HEAD changes.
find_package(Git QUIET)
set(commit unknown)
if(Git_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} describe --always --abbrev=12 --exclude * --dirty WORKING_DIRECTORY ${SOURCE}
    OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
  if(status EQUAL 0)
    set(commit ${found})
  endif()
endif()
file(WRITE ${OUTPUT} "namespace etalon {
extern const char* const etalon_commit;
const char* const etalon_commit = \"${commit}\";
}  // namespace etalon
")
