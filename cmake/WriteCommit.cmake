# SPDX-License-Identifier: BSD-3-Clause
# Run at every build (cmake -D SOURCE=... -D OUTPUT=... -P): writes a header with the commit that is being built. The file
# is touched only when that changes, so that an unchanged tree builds nothing.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND git -C ${SOURCE} rev-parse HEAD OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE
  ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(commit "unknown")
endif()
execute_process(COMMAND git -C ${SOURCE} status --porcelain --untracked-files=no OUTPUT_VARIABLE changes ERROR_QUIET)
set(dirty "false")
if(changes)
  set(dirty "true")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "// SPDX-License-Identifier: BSD-3-Clause
#pragma once
namespace narrows::build
{
inline constexpr const char *commit = \"${commit}\";
inline constexpr bool dirty = ${dirty};
}
")
