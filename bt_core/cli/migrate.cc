// What becomes of a project that is written for BehaviorTree.CPP: read, and nothing is changed.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "bt_core/base/command_line.h"
#include "bt_core/base/read_file.h"
#include "bt_core/cli/verbs.h"

namespace coppice {
namespace {

namespace fs = std::filesystem;

enum class Kind { kFine, kNote, kStop };

struct Finding {
  std::string_view text;  // in a line, where a word begins
  Kind kind;
  std::string_view what;
};

// Of CMake files.
constexpr Finding kInCMake[] = {
    {"find_package(behaviortree_cpp_v3", Kind::kFine,
     "finds Coppice's package of that name; link BT::behaviortree_cpp_v3"},
    {"find_package(behaviortree_cpp", Kind::kFine,
     "finds Coppice's package of that name; link BT::behaviortree_cpp"},
    {"FetchContent_Declare(behaviortree", Kind::kStop,
     "fetches the other library; use find_package(behaviortree_cpp)"},
    {"BTCPP_LIBRARY", Kind::kStop, "is a variable of the other library's own build"},
};

// Of C++. Headers that are parts of the other library come first.
constexpr Finding kInSource[] = {
    {"behaviortree_cpp/contrib/any.hpp", Kind::kStop, "is not there; BT::Any is"},
    {"behaviortree_cpp/contrib/minicoro.h", Kind::kStop,
     "is not there; derive from CoroActionNode"},
    {"behaviortree_cpp/scripting/operators.hpp", Kind::kStop, "is not there"},
    {"behaviortree_cpp/utils/timer_queue.h", Kind::kStop,
     "is not there; timers belong to the tree"},
    {"behaviortree_cpp/utils/simple_string.hpp", Kind::kStop, "is not there; use std::string"},
    {"behaviortree_cpp/utils/convert_impl.hpp", Kind::kStop, "is not there; BT::Any converts"},
    {"behaviortree_cpp/actions/pop_from_queue.hpp", Kind::kStop, "is not there; use LoopNode"},
    {"behaviortree_cpp/decorators/consume_queue.h", Kind::kStop, "is not there; use LoopNode"},
    {"behaviortree_cpp/controls/manual_node.h", Kind::kStop, "is not there"},
    {"behaviortree_cpp/loggers/groot2_protocol.h", Kind::kStop,
     "is not there; docs/live.md describes the protocol"},
    {"VerifyXML(", Kind::kStop,
     "is not there; the factory checks every tree, and so does "
     "`coppice check`"},
    {"getAny(", Kind::kStop, "is not there; use getAnyLocked()"},
    {"linb::any", Kind::kStop, "is not there; use BT::Any"},
    {"destroyCoroutine(", Kind::kStop, "is not there; halt() does it"},
    {"setWakeUpInstance(", Kind::kStop, "is not there; the tree does it"},
    {"EnableException(", Kind::kStop, "is not there; a node that throws ends the tick"},
    {"entry_mutex", Kind::kNote, "getEntry() is a copy of the key: to write, call set()"},
    {"getEntry(", Kind::kNote, "is a copy of the key: to write, call set()"},
    {"Groot2Publisher", Kind::kNote, "listens on this computer only (docs/live.md)"},
    {"PublisherZMQ", Kind::kNote, "speaks the protocol of Groot2, at the server's port"},
    {"FileLogger ", Kind::kNote, "writes a .btlog, the log of version 4"},
    {"CoroActionNode", Kind::kNote, "when it is halted, the destructors in tick() run"},
};

// What nobody can derive from here.
constexpr std::string_view kBuiltIn[] = {"SequenceNode",
                                         "FallbackNode",
                                         "ReactiveSequence",
                                         "ReactiveFallback",
                                         "ParallelNode",
                                         "ParallelAllNode",
                                         "IfThenElseNode",
                                         "WhileDoElseNode",
                                         "SwitchNode",
                                         "SequenceWithMemory",
                                         "TryCatchNode",
                                         "InverterNode",
                                         "RetryNode",
                                         "RepeatNode",
                                         "TimeoutNode",
                                         "DelayNode",
                                         "ForceSuccessNode",
                                         "ForceFailureNode",
                                         "KeepRunningUntilFailureNode",
                                         "RunOnceNode",
                                         "PreconditionNode",
                                         "SubTreeNode",
                                         "SetBlackboardNode",
                                         "ScriptNode",
                                         "SleepNode",
                                         "AlwaysSuccessNode",
                                         "AlwaysFailureNode"};

bool IsPartOfName(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// As a word of its own: `getAny(` is not in `tryGetAny(`.
bool Has(std::string_view line, std::string_view text) {
  for (std::size_t at = line.find(text); at != std::string_view::npos;
       at = line.find(text, at + 1)) {
    if (at == 0 || !IsPartOfName(line[at - 1])) return true;
  }
  return false;
}

bool Derives(std::string_view line, std::string_view base) {
  for (const std::string_view how : {"public BT::", "public "}) {
    const std::size_t at = line.find(std::string(how) + std::string(base));
    if (at == std::string_view::npos) continue;
    const std::size_t end = at + how.size() + base.size();
    if (end == line.size() || !IsPartOfName(line[end])) return true;
  }
  return false;
}

bool EndsWith(std::string_view name, std::string_view end) {
  return name.size() >= end.size() && name.substr(name.size() - end.size()) == end;
}

bool IsSource(const std::string& name) {
  for (const char* end : {".h", ".hh", ".hpp", ".hxx", ".cc", ".cpp", ".cxx"}) {
    if (EndsWith(name, end)) return true;
  }
  return false;
}
bool IsCMake(const std::string& name) {
  return name == "CMakeLists.txt" || EndsWith(name, ".cmake");
}

class Survey {
 public:
  void Read(const fs::path& file) {
    const std::string name = file.filename().string();
    if (IsCMake(name)) ReadLines(file, std::begin(kInCMake), std::end(kInCMake), false);
    if (IsSource(name)) ReadLines(file, std::begin(kInSource), std::end(kInSource), true);
  }

  int Conclude() const {
    std::cout << files_ << " files read, " << users_ << " use BehaviorTree.CPP: " << stops_
              << " lines will not compile, " << notes_ << " behave otherwise\n";
    if (files_ > 0) std::cout << "trees: coppice check FILE.xml\n";
    return stops_ > 0 ? 1 : 0;
  }

 private:
  void ReadLines(const fs::path& file, const Finding* begin, const Finding* end, bool is_source) {
    Diagnostics diagnostics;
    const std::optional<std::string> text = ReadFile(file.string(), diagnostics);
    std::cerr << diagnostics.ToString();
    if (!text) return;
    ++files_;
    users_ += text->find("behaviortree_cpp") != std::string::npos;
    std::size_t number = 0;
    for (std::size_t start = 0; start < text->size(); ++number) {
      const std::size_t stop = std::min(text->find('\n', start), text->size());
      ReadLine(std::string_view(*text).substr(start, stop - start),
               file.string() + ":" + std::to_string(number + 1), begin, end, is_source);
      start = stop + 1;
    }
  }

  void ReadLine(std::string_view line, const std::string& place, const Finding* begin,
                const Finding* end, bool is_source) {
    const Finding* const found =
        std::find_if(begin, end, [&](const Finding& finding) { return Has(line, finding.text); });
    if (found != end) Tell(place, found->kind, found->text, found->what);
    if (!is_source) return;
    for (const std::string_view base : kBuiltIn) {
      if (!Derives(line, base)) continue;
      Tell(place, Kind::kStop, base, "is built in and cannot be derived from; see UserControl");
    }
  }

  void Tell(const std::string& place, Kind kind, std::string_view text, std::string_view what) {
    constexpr const char* kWords[] = {"fine", "note", "stop"};
    std::cout << place << ": " << kWords[static_cast<int>(kind)] << ": " << text << " " << what
              << "\n";
    stops_ += kind == Kind::kStop;
    notes_ += kind == Kind::kNote;
  }

  int files_ = 0;
  int users_ = 0;
  int stops_ = 0;
  int notes_ = 0;
};

// In the order of their names; hidden folders and build folders are left out.
std::vector<fs::path> FilesBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  const auto options = fs::directory_options::skip_permission_denied;
  std::error_code error;
  for (auto at = fs::recursive_directory_iterator(folder, options, error);
       at != fs::recursive_directory_iterator(); at.increment(error)) {
    const std::string name = at->path().filename().string();
    const bool is_folder = at->is_directory(error);
    if (is_folder && (name.front() == '.' || fs::exists(at->path() / "CMakeCache.txt", error))) {
      at.disable_recursion_pending();
    }
    if (at->is_regular_file(error)) files.push_back(at->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

const Command& MigrateCommand() {
  static const Command command{
      "coppice migrate",
      "say what becomes of code for BehaviorTree.CPP",
      {"DIR", 1, 1},
      R"(Reads the CMake files and C++ sources below a folder that are written for
BehaviorTree.CPP, and says which lines will compile and run as they do (fine), which behave
otherwise (note) and which will not compile (stop). Nothing is changed. docs/migration.md is the
manual.)",
      {}};
  return command;
}

int RunMigrate(const Arguments& arguments) {
  const Options options = ParseOptions(MigrateCommand(), arguments);
  if (options.exit) return *options.exit;
  const std::string& folder = options.files.front();
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    std::cerr << folder << ": error: no such folder\n";
    return 2;
  }
  Survey survey;
  for (const fs::path& file : FilesBelow(folder)) survey.Read(file);
  return survey.Conclude();
}

}  // namespace coppice
