#include "bt_core/cli/replay/replay.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>

#include "bt_core/analysis/compare.h"
#include "bt_core/analysis/load_recording.h"
#include "bt_core/analysis/play/verify.h"
#include "bt_core/analysis/why/why_text.h"
#include "bt_core/base/command_line.h"
#include "bt_core/cli/plain_output.h"
#include "bt_core/cli/plugins.h"
#include "bt_core/cli/replay/replay_printer.h"
#include "bt_core/cli/replay/replay_scenario.h"
#include "bt_core/cli/replay/replay_tree.h"
#include "bt_core/cli/replay/scrubber.h"

namespace coppice {
namespace {

// Of one run, as the options say.
class Replay {
 public:
  Replay(const Options& options, const Recording& run) : options_(options), run_(run) {}

  int Run() {
    const PlainOutput output;
    if (options_.Has("--verify")) return VerifyAll();
    if (options_.Has("--why")) return Explain(options_.Get("--why"));
    if (options_.Has("--why-not")) return Explain(options_.Get("--why-not"));
    if (options_.Has("--scenario")) return MakeScenario(options_, run_);
    if (options_.Has("--at") || options_.Has("--tick")) return ShowOne();
    return PrintAll();
  }

  // In a terminal, to go back and forth.
  bool IsForPeople() const {
    static const char* const kOthers[] = {"--verify", "--why",  "--why-not", "--scenario",
                                          "--at",     "--tick", "--print",   "--json",
                                          "--node",   "--from", "--to"};
    return isatty(STDIN_FILENO) && isatty(STDOUT_FILENO) &&
           std::none_of(std::begin(kOthers), std::end(kOthers),
                        [this](const char* option) { return options_.Has(option); });
  }

 private:
  bool is_json() const { return options_.Has("--json"); }

  int PrintAll() {
    ReplayFilter filter;
    filter.pattern = options_.Get("--node");
    for (const auto& [name, time] :
         {std::make_pair("--from", &filter.from), {"--to", &filter.to}}) {
      if (options_.Has(name)) *time = RecordTime(options_, name, run_.start());
    }
    const auto printer =
        is_json() ? MakeJsonPrinter(std::cout) : MakeTextPrinter(std::cout, run_.start());
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
      entry = run_.FindTime(RecordTime(options_, "--at", run_.start()));
    } else if (options_.Has("--tick")) {
      entry = run_.Find(static_cast<std::uint64_t>(options_.Whole("--tick", 0)));
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
  const PlainOutput output;
  const RunComparison comparison = CompareRuns(first, second);
  std::cout << (is_json ? ComparisonToJson(comparison) + "\n" : PrintComparison(comparison));
  return comparison.is_the_same() ? 0 : 1;
}

}  // namespace

CommandOption MemoryOption() {
  return CommandOption::Whole("--memory", "MIB", 1, 1 << 20,
                              "that a run may take, about; else 128 and 256 times its files,\n"
                              "at most 1024");
}

std::optional<std::size_t> MemoryOf(const Options& options) {
  if (!options.Has("--memory")) return std::nullopt;
  return static_cast<std::size_t>(options.Whole("--memory", 0)) << 20;
}

const Command& ReplayCommand() {
  const auto seconds = [](const char* name, const char* help) {
    return CommandOption::Real(name, "SECONDS", -1e9, 1e9, help);
  };
  static const Command command{
      "coppice replay",
      "go back and forth in a recorded run; why, verify, compare",
      {"FILE [OTHER]", 1, 2},
      R"(Shows what happened in a recorded run: in a terminal to go back and forth in it, else
tick by tick. Times are in seconds since the start of the record.)",
      {CommandOption::Flag("--print", "tick by tick, also in a terminal"),
       CommandOption::Flag("--json", "one JSON object per line"),
       CommandOption::Text("--node", "PATTERN",
                           "only nodes whose path fits, for example 'patrol/*'"),
       seconds("--from", "only what comes then and later"),
       seconds("--to", "only what came until then"), seconds("--at", "how the tree stood then"),
       CommandOption::Whole("--tick", "N", 0, 1e15,
                            "how it stood at that tick; without it and --at: at the last one"),
       CommandOption::Text("--why", "NODE",
                           "why that node had its status; NODE is its path or the end of it"),
       CommandOption::Text("--why-not", "NODE", "why that node was not ticked"),
       CommandOption::Flag("--verify",
                           "runs the tree again with the recorded inputs: does it do the same?"),
       MemoryOption(), PluginOption(), CommandOption::Flag("--diff", "where FILE and OTHER part"),
       CommandOption::Text("--scenario", "OUT",
                           "makes a test of the run, which `coppice test OUT` plays"),
       CommandOption::Text("--name", "NAME", "of that test"),
       CommandOption::Text("--tree-file", "XML",
                           "where its tree lies, if not where it lay on the robot"),
       CommandOption::Text("--models", "XML",
                           "a file that describes decorators of the robot's own, if not as the "
                           "record does")}};
  return command;
}

int RunReplay(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions(ReplayCommand(), arguments);
  if (options.exit) return *options.exit;
  const std::size_t files = options.Has("--diff") ? 2 : 1;
  if (options.files.size() != files) {
    return RefuseOptions(ReplayCommand(), files == 1 ? "expected one file" : "expected two files");
  }
  std::vector<Recording> runs;
  for (const std::string& file : options.files) {
    Diagnostics diagnostics;
    std::optional<Recording> run = LoadRecording(file, diagnostics, MemoryOf(options));
    std::cerr << diagnostics.ToString();
    if (!run) return 2;
    runs.push_back(*std::move(run));
  }
  if (files == 2) return CompareFiles(runs[0], runs[1], options.Has("--json"));
  Replay replay(options, runs[0]);
  return replay.IsForPeople() ? RunScrubber(runs[0]) : replay.Run();
}

}  // namespace coppice
