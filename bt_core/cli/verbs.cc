#include "bt_core/cli/verbs.h"

#include "bt_core/cli/replay/replay.h"

namespace coppice {

std::string Verb::name() const {
  const std::string& whole = command().name;
  return whole.substr(whole.find(' ') + 1);
}

const std::vector<Verb>& Verbs() {
  static const std::vector<Verb> verbs = {
      {CatCommand, RunCat},
      {CheckCommand, RunCheck},
      {CompletionCommand, RunCompletion},
      {ConvertCommand, RunConvert},
      {LiveVerbCommand, RunLive},
      {MigrateCommand, RunMigrate},
      {NodesCommand, RunNodes},
      {RecordCommand, RunRecord},
      {ReplayCommand, RunReplay},
      {RunCommand, RunTree},
      {StatsCommand, RunStats},
      {TestCommand, RunTest},
      {TraceCommand, RunTrace},
      {UpgradeCommand, RunUpgrade},
  };
  return verbs;
}

}  // namespace coppice
