#include "bt_core/cli/replay/replay.h"

#include <unistd.h>

#include <iostream>
#include <memory>
#include <optional>

#include "bt_core/analysis/compare.h"
#include "bt_core/analysis/load_recording.h"
#include "bt_core/analysis/play/verify.h"
#include "bt_core/analysis/why/why_text.h"
#include "bt_core/base/command_line.h"
#include "bt_core/cli/plugins.h"
#include "bt_core/cli/replay/replay_printer.h"
#include "bt_core/cli/replay/replay_scenario.h"
#include "bt_core/cli/replay/replay_tree.h"
#include "bt_core/cli/replay/scrubber.h"

namespace coppice {
namespace {

constexpr char kUsage[] =
    "coppice replay FILE [--print] [--json] [--node PATTERN] [--from SECONDS] [--to SECONDS]\n"
    "coppice replay FILE [--at SECONDS | --tick N] [--why NODE | --why-not NODE] [--json]\n"
    "coppice replay --verify FILE [--plugin LIBRARY] [--json]\n"
    "coppice replay --diff FILE OTHER [--json]\n"
    "coppice replay FILE --scenario OUT [--name NAME] [--tree-file XML] [--models XML] [--from S]\n"
    "               [--to S]\n"
    "  Shows what happened in a recorded run: in a terminal to go back and forth in it, else tick\n"
    "  by tick.\n"
    "  --print      tick by tick, also in a terminal\n"
    "  --json       one JSON object per line\n"
    "  --node       only nodes whose path fits, for example 'patrol/*'\n"
    "  --from/to    only that part, in seconds since the start of the record\n"
    "  --at, --tick how the tree stood then; without them the last tick\n"
    "  --why        why that node had its status; NODE is its path or the end of it\n"
    "  --why-not    why that node was not ticked\n"
    "  --verify     runs the tree again with the recorded inputs: does it do the same?\n"
    "  --diff       where two runs part\n"
    "  --scenario   makes a test of the run, which `coppice test OUT` plays; --tree-file: where "
    "its\n"
    "               tree lies, if not where it lay on the robot; --models: a file that describes\n"
    "               decorators of the robot's own, if not as the record does";

int Fail(const std::string& problem) {
  std::cerr << problem << "\nusage: " << kUsage << "\n";
  return 2;
}

// Of one run, as the options say.
class Replay {
 public:
  Replay(const Options& options, const Recording& run) : options_(options), run_(run) {}

  int Run() {
    if (options_.Has("--verify")) return VerifyAll();
    if (options_.Has("--why")) return Explain(options_.Get("--why"));
    if (options_.Has("--why-not")) return Explain(options_.Get("--why-not"));
    if (options_.Has("--scenario")) return MakeScenario(options_, run_);
    if (options_.Has("--at") || options_.Has("--tick")) return ShowOne();
    const bool plain = options_.Has("--print") || is_json() || options_.Has("--node") ||
                       options_.Has("--from") || options_.Has("--to");
    if (!plain && isatty(STDIN_FILENO) && isatty(STDOUT_FILENO)) return RunScrubber(run_);
    return PrintAll();
  }

 private:
  bool is_json() const { return options_.Has("--json"); }

  int PrintAll() {
    ReplayFilter filter;
    filter.pattern = options_.Get("--node");
    for (const auto& [name, time] :
         {std::make_pair("--from", &filter.from), {"--to", &filter.to}}) {
      if (!options_.Has(name)) continue;
      const std::optional<Time> given = ReadRecordTime(options_.Get(name), run_.start());
      if (!given) return Fail(std::string(name) + " needs a number of seconds");
      *time = *given;
    }
    const auto printer = is_json() ? MakeJsonPrinter(std::cout, run_.start())
                                   : MakeTextPrinter(std::cout, run_.start());
    return PrintRun(run_, filter, *printer).complete() ? 0 : 1;
  }

  // The entry that --at or --tick name, or the last tick; nothing, with a message, if there is
  // none.
  std::optional<std::size_t> Entry() const {
    if (run_.ticks().empty()) {
      std::cerr << "there is no tick in this record\n";
      return std::nullopt;
    }
    std::size_t entry = run_.ticks().size() - 1;
    if (options_.Has("--at")) {
      const std::optional<Time> time = ReadRecordTime(options_.Get("--at"), run_.start());
      if (!time) {
        Fail("--at needs a number of seconds");
        return std::nullopt;
      }
      entry = run_.FindTime(*time);
    } else if (options_.Has("--tick")) {
      const std::optional<std::int64_t> tick = options_.GetNumber("--tick");
      if (!tick || *tick < 0) {
        Fail("--tick needs the number of a tick");
        return std::nullopt;
      }
      entry = run_.Find(static_cast<std::uint64_t>(*tick));
    } else {
      while (entry > 0 && run_.ticks()[entry].result == Status::kIdle) --entry;
    }
    if (entry < run_.ticks().size()) return entry;
    std::cerr << "the record ends with tick " << run_.ticks().back().number << "\n";
    return std::nullopt;
  }

  int ShowOne() {
    const std::optional<std::size_t> entry = Entry();
    if (!entry) return 2;
    const TreeDescription& tree = run_.trees()[run_.TreeOf(*entry)];
    const TreePicture picture = PictureOf(run_, *entry);
    std::cout << (is_json() ? PictureToJson(tree, picture, run_.start()) + "\n"
                            : PrintPicture(tree, picture, run_.start()));
    return 0;
  }

  int Explain(const std::string& path) {
    const std::optional<std::size_t> entry = Entry();
    const std::shared_ptr<Registry> registry = RegistryWithPlugins(options_);
    if (!entry || !registry) return 2;
    Diagnostics diagnostics;
    const RecordedTree tree =
        CompileRecorded(run_.trees()[run_.TreeOf(*entry)], registry, diagnostics);
    const NodeIndex node = tree.Find(path, diagnostics);
    std::cerr << diagnostics.ToString();
    if (node == kNoNode) return 2;
    const TickView now = run_.Before(*entry);
    std::optional<TickView> before;
    if (const auto earlier = run_.TickBefore(*entry)) before = run_.Before(*earlier);
    const Why why = WhyOf(tree, now, before ? &*before : nullptr, node);
    std::cout << (is_json() ? WhyToJson(tree, why, run_.start()) + "\n"
                            : PrintWhy(tree, why, run_.start()));
    return options_.Has("--why-not") && why.was_ticked ? 1 : 0;
  }

  int VerifyAll() {
    if (!RegistryWithPlugins(options_)) return 2;
    Diagnostics diagnostics;
    const Verification verification = Verify(
        run_, [this] { return RegistryWithPlugins(options_); }, diagnostics);
    std::cerr << diagnostics.ToString();
    std::cout << (is_json() ? VerificationToJson(verification, run_.start()) + "\n"
                            : PrintVerification(verification, run_.start()));
    return verification.is_the_same() ? 0 : 1;
  }

  const Options& options_;
  const Recording& run_;
};

int CompareFiles(const Recording& first, const Recording& second, bool is_json) {
  const RunComparison comparison = CompareRuns(first, second);
  std::cout << (is_json ? ComparisonToJson(comparison) + "\n" : PrintComparison(comparison));
  return comparison.is_the_same() ? 0 : 1;
}

}  // namespace

int RunReplay(const std::vector<std::string>& arguments) {
  const std::optional<Options> options =
      ParseOptions(arguments,
                   {"--node", "--from", "--to", "--at", "--tick", "--why", "--why-not", "--plugin",
                    "--scenario", "--name", "--tree-file", "--models"},
                   {"--json", "--print", "--verify", "--diff"}, kUsage);
  if (!options) return 2;
  const std::size_t files = options->Has("--diff") ? 2 : 1;
  if (options->files.size() != files) {
    return Fail(files == 1 ? "expected one file" : "expected two files");
  }
  std::vector<Recording> runs;
  for (const std::string& file : options->files) {
    Diagnostics diagnostics;
    std::optional<Recording> run = LoadRecording(file, diagnostics);
    std::cerr << diagnostics.ToString();
    if (!run) return 2;
    runs.push_back(*std::move(run));
  }
  if (files == 2) return CompareFiles(runs[0], runs[1], options->Has("--json"));
  return Replay(*options, runs[0]).Run();
}

}  // namespace coppice
