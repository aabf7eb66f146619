// A program of verbs, as git is one: `coppice-store export --help`.
//
//   const std::vector<Verb> kVerbs = {{"run", kRun, Run}, {"export", kExport, Export}};
//   return RunVerb("coppice-store", kVerbs, {argv + 1, argv + argc});
#ifndef COPPICE_BT_CORE_BASE_VERBS_H_
#define COPPICE_BT_CORE_BASE_VERBS_H_

#include <string>
#include <vector>

#include "bt_core/base/command_line.h"

namespace coppice {

struct Verb {
  const char* name;
  const Command& command;
  int (*run)(const Options& options);  ///< returns the exit status
};

/// Runs the verb that the first argument names with the others as its options. Without one, with
/// an unknown one (the nearest is told) or with options that the verb has not, it says so and
/// returns 2; --help prints the list of the verbs.
int RunVerb(const std::string& program, const std::vector<Verb>& verbs,
            const std::vector<std::string>& arguments);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_BASE_VERBS_H_
