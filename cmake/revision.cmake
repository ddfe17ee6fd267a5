# Writes ${OUT}, the C++ source that names the commit, if it is not so already: run at every build
# (cmake -DSOURCE=… -DOUT=… -P revision.cmake), it makes one small file compile after a commit.
set(exported "$Format:%H$")  # `git archive` puts the commit here
set(commit "")
set(changed false)

if(NOT exported MATCHES "^.Format")
  set(commit ${exported})
else()
  set(ENV{GIT_OPTIONAL_LOCKS} 0)  # a build is not to be in the way of a commit
  execute_process(COMMAND git rev-parse --show-toplevel HEAD WORKING_DIRECTORY ${SOURCE}
                  OUTPUT_VARIABLE answer RESULT_VARIABLE failed ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  file(REAL_PATH ${SOURCE} source)
  # A tarball unpacked within another repository is not of its commits.
  if(NOT failed AND answer MATCHES "^(.*)\n([0-9a-f]+)$" AND CMAKE_MATCH_1 STREQUAL source)
    set(commit ${CMAKE_MATCH_2})
    execute_process(COMMAND git status --porcelain --untracked-files=no WORKING_DIRECTORY ${SOURCE}
                    OUTPUT_VARIABLE differences ERROR_QUIET)
    if(differences)
      set(changed true)
    endif()
  endif()
endif()

file(CONFIGURE OUTPUT ${OUT} @ONLY CONTENT [[
#include "base/version.hpp"

namespace tt {

const Revision revision{"@commit@", @changed@};

}  // namespace tt
]])
