#include "robot_app/supervision/robot_config.h"

#include <algorithm>
#include <optional>
#include <set>

#include "robot_app/supervision/yaml_fields.h"

namespace coppice::robot {
namespace {

class Loader {
 public:
  Loader(const std::string& path, const Variables& variables, Diagnostics& diagnostics)
      : file_(YamlFields::Load(path, diagnostics)), variables_(variables) {
    if (diagnostics.has_errors()) return;
    readable_ = true;
  }

  RobotConfig Load() {
    if (!readable_) return {};
    for (auto& [name, value] : file_.Pairs("parameters")) {
      if (!value.IsScalar()) file_.Error(name.where, "\"" + name.text + "\": expected one value");
      if (value.IsScalar()) config_.parameters[name.text] = value.Scalar();
    }
    ReadLimits();
    ReadProcesses();
    ResolveDependencies();
    FindCycles();
    ReadConfigurations();
    file_.Finish();
    return std::move(config_);
  }

 private:
  void ReadLimits() {
    YamlFields intensity = file_.Map("restart_intensity");
    config_.intensity.restarts = intensity.Integer("restarts", 3, 0, 1000);
    config_.intensity.window = intensity.Seconds("window", 60, 1, 86400);
    intensity.Finish();
    YamlFields back_off = file_.Map("back_off");
    config_.back_off.first = back_off.Seconds("first", 1, 0.01, 3600);
    config_.back_off.most = back_off.Seconds("most", 30, 0.01, 3600);
    back_off.Finish();
    config_.stop_timeout = file_.Seconds("stop_timeout", 3, 0.1, 600);
  }

  void ReadProcesses() {
    for (YamlFields& fields : file_.Maps("processes")) ReadProcess(fields);
    if (config_.processes.empty()) file_.Error(file_.where(), "\"processes\" names no process");
  }

  void ReadProcess(YamlFields& fields) {
    ProcessConfig process;
    const LocatedText name = fields.Text("name");
    process.name = name.text;
    if (Find(name.text)) fields.Error(name.where, "duplicate process \"" + name.text + "\"");

    const std::vector<LocatedText> command = fields.Texts("command");
    if (command.empty()) fields.Error(fields.where(), "\"command\" is missing");
    for (const LocatedText& word : command) process.command.push_back(Fill(word));

    const LocatedText node = fields.Text("node", "");
    process.node = node.text;
    if (!node.text.empty() && node.text.front() != '/') {
      fields.Error(node.where,
                   "\"node\": expected a ROS name with slash, got \"" + node.text + "\"");
    }
    ReadReadiness(fields, process);
    process.start_timeout = fields.Seconds("start_timeout", 20, 0.1, 3600);
    const std::string rule =
        fields.Choice("restart", "by_tree", {"by_tree", "on_failure", "always"});
    if (rule == "always") process.restart = RestartRule::kAlways;
    if (rule == "on_failure") process.restart = RestartRule::kOnFailure;
    process.log = fields.Text("log", process.name + ".log").text;
    depends_.push_back(fields.Texts("depends"));
    after_.push_back(fields.Texts("after"));
    where_.push_back(fields.where());
    fields.Finish();
    config_.processes.push_back(std::move(process));
  }

  // "node", "none" or "topic NAME".
  void ReadReadiness(YamlFields& fields, ProcessConfig& process) {
    const LocatedText ready = fields.Text("ready", process.node.empty() ? "none" : "node");
    const std::string topic_word = "topic ";
    if (ready.text == "none") {
      process.ready = Readiness::kNone;
    } else if (ready.text == "node") {
      process.ready = Readiness::kNode;
    } else if (ready.text.rfind(topic_word + "/", 0) == 0) {
      process.ready = Readiness::kTopic;
      process.ready_topic = ready.text.substr(topic_word.size());
    } else {
      fields.Error(ready.where,
                   "\"ready\": \"" + ready.text + "\" is none of node, none, topic /NAME",
                   DidYouMean(ready.text, {"node", "none"}));
    }
    if (process.ready != Readiness::kNone && process.node.empty()) {
      fields.Error(ready.where, "\"ready\": " + ready.text + " needs \"node\"");
    }
  }

  void ResolveDependencies() {
    for (std::size_t i = 0; i < config_.processes.size(); ++i) {
      ProcessConfig& process = config_.processes[i];
      for (const LocatedText& name : depends_[i]) {
        if (const auto index = Resolve(name)) process.depends.push_back(*index);
      }
      for (const LocatedText& name : after_[i]) {
        if (const auto index = Resolve(name)) process.after.push_back(*index);
      }
    }
  }

  // A process that waits for itself, directly or through others.
  void FindCycles() {
    for (std::size_t start = 0; start < config_.processes.size(); ++start) {
      std::set<std::size_t> seen;
      std::vector<std::size_t> pending = {start};
      while (!pending.empty()) {
        const ProcessConfig& process = config_.processes[pending.back()];
        pending.pop_back();
        for (const auto* list : {&process.depends, &process.after}) {
          for (const std::size_t next : *list) {
            if (seen.insert(next).second) pending.push_back(next);
          }
        }
      }
      if (seen.count(start) == 0) continue;
      file_.Error(where_[start], "process \"" + config_.processes[start].name +
                                     "\" waits for itself (depends, after)");
    }
  }

  void ReadConfigurations() {
    for (auto& [name, list] : file_.Pairs("configurations")) {
      Configuration configuration;
      configuration.name = name.text;
      for (const LocatedText& process : file_.TextsOf(list)) {
        if (const auto index = Resolve(process)) configuration.processes.push_back(*index);
      }
      CheckComplete(name, configuration);
      config_.configurations.push_back(std::move(configuration));
    }
    if (config_.configurations.empty()) {
      file_.Error(file_.where(), "\"configurations\" names no configuration");
      return;
    }
    ReadInitial();
  }

  void ReadInitial() {
    const LocatedText initial = file_.Text("initial", config_.configurations.front().name);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < config_.configurations.size(); ++i) {
      names.push_back(config_.configurations[i].name);
      if (names.back() == initial.text) config_.initial = i;
    }
    if (names[config_.initial] != initial.text) {
      file_.Error(initial.where, "unknown configuration \"" + initial.text + "\"",
                  DidYouMean(initial.text, names));
    }
  }

  // A process would wait for ever for a dependency that is not part of its configuration.
  void CheckComplete(const LocatedText& name, const Configuration& configuration) {
    const auto& members = configuration.processes;
    for (const std::size_t member : members) {
      for (const std::size_t needed : config_.processes[member].depends) {
        if (std::find(members.begin(), members.end(), needed) != members.end()) continue;
        file_.Error(name.where, "configuration \"" + name.text + "\" has \"" +
                                    config_.processes[member].name + "\" but not \"" +
                                    config_.processes[needed].name + "\", which it depends on");
      }
    }
  }

  std::optional<std::size_t> Find(const std::string& name) const {
    for (std::size_t i = 0; i < config_.processes.size(); ++i) {
      if (config_.processes[i].name == name) return i;
    }
    return std::nullopt;
  }

  std::optional<std::size_t> Resolve(const LocatedText& name) const {
    const auto index = Find(name.text);
    if (index) return index;
    std::vector<std::string> names;
    for (const ProcessConfig& process : config_.processes) names.push_back(process.name);
    file_.Error(name.where, "unknown process \"" + name.text + "\"", DidYouMean(name.text, names));
    return std::nullopt;
  }

  std::string Fill(const LocatedText& word) const {
    std::string filled;
    std::size_t position = 0;
    while (true) {
      const std::size_t begin = word.text.find("${", position);
      filled += word.text.substr(position, begin - position);
      if (begin == std::string::npos) return filled;
      const std::size_t end = MatchingBrace(word.text, begin + 2);
      if (end == std::string::npos) {
        file_.Error(word.where, "\"${\" without \"}\" in \"" + word.text + "\"");
        return filled;
      }
      filled += Lookup(word.text.substr(begin + 2, end - begin - 2), word.where);
      position = end + 1;
    }
  }

  // Of the brace that was opened just before `position`; npos if there is none.
  static std::size_t MatchingBrace(const std::string& text, std::size_t position) {
    int open = 1;
    for (; position < text.size(); ++position) {
      if (text.compare(position, 2, "${") == 0) ++open;
      if (text[position] == '}' && --open == 0) return position;
    }
    return std::string::npos;
  }

  std::string Lookup(const std::string& expression, const SourceLocation& where) const {
    const std::size_t separator = expression.find(":-");
    const std::string name = expression.substr(0, separator);
    const auto found = variables_.find(name);
    if (found != variables_.end()) return found->second;
    if (separator != std::string::npos) {
      return Fill({expression.substr(separator + 2), where});
    }
    std::vector<std::string> names;
    for (const auto& [known, value] : variables_) names.push_back(known);
    const std::string hint = DidYouMean(name, names);
    file_.Error(where, "variable \"" + name + "\" has no value",
                hint.empty() ? "give it with --set " + name + "=VALUE" : hint);
    return "";
  }

  YamlFields file_;
  const Variables& variables_;
  bool readable_ = false;
  RobotConfig config_;
  // Per process, as written.
  std::vector<std::vector<LocatedText>> depends_, after_;
  std::vector<SourceLocation> where_;
};

}  // namespace

RobotConfig LoadRobotConfig(const std::string& path, const Variables& variables,
                            Diagnostics& diagnostics) {
  return Loader(path, variables, diagnostics).Load();
}

}  // namespace coppice::robot
