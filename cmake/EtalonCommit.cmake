# Writes OUTPUT, a source file with the commit of the tree SOURCE, "-dirty" where files differ from it, and
# DEPFILE, which lists all that this depends on: Git's files, and the files of the tree, removed ones too. A
# tree that is not itself that of a repository, such as a tarball unpacked within another's, has no commit.
cmake_minimum_required(VERSION 3.25)
find_package(Git QUIET)

# Sets `result` to what Git prints, without the last newline, and `status` to 0 if it succeeded.
macro(git result)
  execute_process(COMMAND ${GIT_EXECUTABLE} -c core.quotePath=false ${ARGN} WORKING_DIRECTORY ${SOURCE}
    OUTPUT_VARIABLE ${result} OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
endmacro()

set(commit unknown)
set(files "")
if(Git_FOUND)
  git(prefix rev-parse --show-prefix)
  if(status EQUAL 0 AND prefix STREQUAL "")
    git(found describe --always --abbrev=12 "--exclude=*" --dirty)
    if(status EQUAL 0)
      set(commit ${found})
    endif()
    git(files ls-files)
    foreach(name HEAD logs/HEAD index)
      git(path rev-parse --git-path ${name})
      get_filename_component(path "${path}" ABSOLUTE BASE_DIR ${SOURCE})
      if(EXISTS ${path})
        string(APPEND files "\n${path}")
      endif()
    endforeach()
  endif()
endif()

set(text "namespace etalon {
extern const char* const etalon_commit;
const char* const etalon_commit = \"${commit}\";
}  // namespace etalon
")
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "${text}" @ONLY) # leaves a file alone that has this text

string(REPLACE " " "\\ " files "\n${files}")
string(REGEX REPLACE "\n([^/\n])" "\n${SOURCE}/\\1" files "${files}")
string(REPLACE "\n" " \\\n  " files "${files}")
file(WRITE ${DEPFILE} "${OUTPUT}:${files}\n")
