#include "robot_app/processes/config/robot_config.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <optional>

#include "bt_core/base/advisor.h"
#include "bt_core/base/read_file.h"
#include "robot_app/common/ros_name.h"
#include "robot_app/common/yaml_fields.h"
#include "robot_app/processes/config/group_order.h"
#include "robot_app/processes/config/robot_config_fields.h"

namespace coppice::robot::processes {
namespace {

constexpr std::size_t kMost = 1000;  // processes, or groups
constexpr std::size_t kMostSiteFiles = 100;
constexpr std::size_t kMostFilled = std::size_t{16} << 20;  // bytes of all texts with variables

class Loader {
 public:
  Loader(const std::string& path, const Variables& variables, Diagnostics& diagnostics)
      : diagnostics_(diagnostics),
        file_(YamlFields::Load(path, diagnostics)),
        variables_(variables) {
    if (diagnostics.has_errors()) return;
    readable_ = true;
  }

  RobotConfig Load() {
    if (!readable_) return {};
    YamlFields sites = file_.Map("sites");
    ReadSites(sites);
    ReadParameters(file_, "parameters", "");
    ReadSiteFiles(sites);
    ReadLimits();
    ReadHostsAndConditions();
    ReadGroups();
    ReadProcesses();
    ResolveDependencies();
    FindCycles();
    FindGroupCycles();
    ReadConfigurations();
    file_.Finish();
    return std::move(config_);
  }

 private:
  // Which site it is has to be known before anything else can be read.
  void ReadSites(YamlFields& fields) {
    for (auto& [name, value] : fields.Pairs("table")) {
      if (!IsFolderName(name.text)) {
        file_.Error(name.where,
                    "site \"" + name.text +
                        "\": expected the name of a folder, of letters, digits, _ and -");
      }
      config_.sites.push_back({name.text, 0});
      YamlFields site = fields.MapOf(value);
      site_configurations_.push_back(site.Text("configuration"));
      site.Finish();
    }
    if (config_.sites.empty()) return;
    LocatedText chosen = fields.Text("initial", config_.sites.front().name);
    const auto wanted = variables_.find("site");
    if (wanted != variables_.end()) chosen.text = wanted->second;
    config_.site = Resolve("site", config_.sites, chosen).value_or(0);
    variables_["site"] = config_.sites[config_.site].name;
  }

  // A site's files lie in folders of its name: a name that leads elsewhere is none.
  static bool IsFolderName(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '_' || c == '-';
    });
  }

  // A site that is not complete is none: it is not entered.
  void ReadSiteFiles(YamlFields& fields) {
    const std::vector<LocatedText> files = fields.Texts("files");
    if (files.size() > kMostSiteFiles) {
      return file_.Error(files.front().where,
                         "expected at most " + std::to_string(kMostSiteFiles) + " files");
    }
    for (const LocatedText& text : files) {
      const std::string path = Fill(text, variables_);
      if (!ReadFile(path)) {
        file_.Error(text.where, "site \"" + variables_["site"] + "\": cannot read " + path);
      } else if (std::filesystem::path(path).extension() == ".yaml") {
        YamlFields::Load(path, diagnostics_);  // a damaged one would end the programs that need it
      }
    }
    if (fields.Has("parameters")) ReadSiteParameters(fields.Text("parameters"));
    config_.site_folder = Fill(fields.Text("folder", ""), variables_);
    fields.Finish();
  }

  // ROS parameters of the nodes that work otherwise at each site.
  void ReadSiteParameters(const LocatedText& path) {
    YamlFields nodes = YamlFields::Load(Fill(path, variables_), diagnostics_);
    for (const std::string& node : nodes.Keys()) ReadParameters(nodes, node, node + "/");
  }

  void ReadParameters(YamlFields& fields, const std::string& key, const std::string& prefix) {
    for (auto& [name, value] : fields.Pairs(key)) {
      if (!value.IsScalar()) fields.Error(name.where, "\"" + name.text + "\": expected one value");
      if (value.IsScalar()) config_.parameters[prefix + name.text] = value.Scalar();
    }
  }

  void ReadLimits() {
    limits_ = ReadRestartLimits(file_.Map("restart_intensity"), {});
    config_.back_off = ReadBackOff(file_.Map("back_off"));
    config_.escalation = ReadEscalation(file_.Map("escalation"));
    YamlFields switch_off = file_.Map("switch_off");
    for (const LocatedText& word : switch_off.Texts("command")) {
      config_.switch_off.push_back(Fill(word, variables_));
    }
    switch_off.Finish();
    config_.stop_timeout = file_.Seconds("stop_timeout", 3, 0.1, 600);
  }

  void ReadHostsAndConditions() {
    for (auto& [name, value] : file_.Pairs("hosts")) {
      config_.hosts.push_back(ReadHost(name, file_.MapOf(value)));
    }
    for (auto& [name, value] : file_.Pairs("conditions")) {
      config_.conditions.push_back(ReadCondition(name, file_.MapOf(value)));
    }
  }

  // None, with an error, if there are too many.
  std::vector<YamlFields> FewMaps(const std::string& key) {
    std::vector<YamlFields> maps = file_.Maps(key);
    if (maps.size() <= kMost) return maps;
    file_.Error(file_.where(),
                "\"" + key + "\": expected at most " + std::to_string(kMost) + " entries");
    return {};
  }

  void ReadGroups() {
    for (YamlFields& fields : FewMaps("groups")) {
      GroupConfig group;
      const LocatedText name = fields.Text("name");
      group.name = name.text;
      if (IndexOf(config_.groups, name.text)) {
        fields.Error(name.where, "duplicate group \"" + name.text + "\"");
      }
      group.strategy = ReadStrategy(fields);
      group.essential = fields.Choice("essential", "yes", {"yes", "no"}) == "yes";
      group.limits = ReadRestartLimits(fields.Map("restart_intensity"), limits_);
      group_depends_.push_back(fields.Texts("depends"));
      group_where_.push_back(fields.where());
      fields.Finish();
      config_.groups.push_back(std::move(group));
    }
  }

  void ReadProcesses() {
    for (YamlFields& fields : FewMaps("processes")) ReadProcess(fields);
    if (config_.processes.empty()) file_.Error(file_.where(), "\"processes\" names no process");
  }

  void ReadProcess(YamlFields& fields) {
    ProcessConfig process;
    const LocatedText name = fields.Text("name");
    process.name = name.text;
    if (IndexOf(config_.processes, name.text)) {
      fields.Error(name.where, "duplicate process \"" + name.text + "\"");
    }
    process.group = GroupOf(fields, process.name);
    process.is_enabled = ReadEnabled(fields);
    if (fields.Has("host")) process.host = Resolve("host", config_.hosts, fields.Text("host"));

    const LocatedText node = fields.Text("node", "");
    process.node = node.text;
    if (!node.text.empty()) ExpectRosName(fields, "node", node);
    ReadReadiness(fields, process);
    process.start_timeout = fields.Seconds("start_timeout", 20, 0.1, 3600);
    process.restart = ReadRestartRule(fields);
    if (fields.Has("heartbeat")) process.heartbeat = ReadHeartbeat(fields.Map("heartbeat"));
    process.log = fields.Text("log", process.name + ".log").text;
    ReadCommand(fields, process);
    ReadState(fields, process);
    depends_.push_back(fields.Texts("depends"));
    after_.push_back(fields.Texts("after"));
    where_.push_back(fields.where());
    fields.Finish();
    config_.groups[process.group].processes.push_back(config_.processes.size());
    config_.processes.push_back(std::move(process));
  }

  // Mostly a variable, so that one who starts the robot can leave the process out.
  bool ReadEnabled(YamlFields& fields) {
    const LocatedText text = fields.Text("enabled", "yes");
    const std::string value = Fill(text, variables_);
    if (value != "yes" && value != "no") {
      fields.Error(text.where, "\"enabled\": expected yes or no, got \"" + value + "\"");
    }
    return value != "no";
  }

  // A process that names no group is one of its own.
  std::size_t GroupOf(YamlFields& fields, const std::string& process) {
    if (fields.Has("group")) {
      if (const auto group = Resolve("group", config_.groups, fields.Text("group"))) return *group;
    }
    if (const auto group = IndexOf(config_.groups, process)) return *group;
    GroupConfig group;
    group.name = process;
    group.limits = limits_;
    config_.groups.push_back(std::move(group));
    group_depends_.emplace_back();
    group_where_.push_back(fields.where());
    return config_.groups.size() - 1;
  }

  void ReadCommand(YamlFields& fields, ProcessConfig& process) {
    const std::vector<LocatedText> command = fields.Texts("command");
    if (command.empty()) fields.Error(fields.where(), "\"command\" is missing");
    Variables variables = variables_;
    if (process.host) variables["bin"] = config_.hosts[*process.host].bin;
    for (const LocatedText& word : command) process.command.push_back(Fill(word, variables));
  }

  // What is deleted must be named so that nothing else can be meant.
  void ReadState(YamlFields& fields, ProcessConfig& process) {
    for (const LocatedText& text : fields.Texts("state")) {
      const std::filesystem::path path = Fill(text, variables_);
      const bool deep = std::distance(path.begin(), path.end()) > 3;
      if (!path.is_absolute() || !deep || path.lexically_normal() != path) {
        file_.Error(text.where, "\"state\": \"" + path.string() +
                                    "\" must be an absolute path without \"..\" at least three "
                                    "folders deep");
      }
      if (process.host) file_.Error(text.where, "\"state\" is only for processes of this host");
      process.state.push_back(path);
    }
  }

  void ResolveDependencies() {
    for (std::size_t i = 0; i < config_.processes.size(); ++i) {
      ProcessConfig& process = config_.processes[i];
      process.depends = ResolveAll("process", config_.processes, depends_[i]);
      process.after = ResolveAll("process", config_.processes, after_[i]);
    }
    for (std::size_t i = 0; i < config_.groups.size(); ++i) {
      GroupConfig& group = config_.groups[i];
      group.depends = ResolveAll("group", config_.groups, group_depends_[i]);
      if (group.strategy != Strategy::kRestForOne) continue;
      for (std::size_t k = 1; k < group.processes.size(); ++k) {
        config_.processes[group.processes[k]].after.push_back(group.processes[k - 1]);
      }
    }
  }

  // A process that waits for itself, directly or through others.
  void FindCycles() {
    const GroupOrder order(config_);
    for (std::size_t start = 0; start < config_.processes.size(); ++start) {
      std::vector<bool> seen(config_.processes.size());
      std::vector<std::size_t> pending = {start};
      while (!pending.empty()) {
        const std::size_t process = pending.back();
        pending.pop_back();
        const Indices* const lists[] = {&order.needs(process), &config_.processes[process].after};
        for (const Indices* list : lists) {
          for (const std::size_t next : *list) {
            if (!seen[next]) pending.push_back(next);
            seen[next] = true;
          }
        }
      }
      if (!seen[start]) continue;
      file_.Error(where_[start], "process \"" + config_.processes[start].name +
                                     "\" waits for itself (depends, after)");
    }
  }

  // Groups that wait for each other, by `depends` of theirs or of their processes.
  void FindGroupCycles() {
    const GroupOrder order(config_);
    for (const std::size_t group : order.circular()) {
      file_.Error(group_where_[group],
                  "group \"" + config_.groups[group].name + "\" waits for itself (depends)");
    }
  }

  void ReadConfigurations() {
    for (auto& [name, value] : file_.Pairs("configurations")) {
      Configuration configuration;
      configuration.name = name.text;
      std::vector<LocatedText> processes, conditions;
      if (value.IsMap()) {
        YamlFields fields = file_.MapOf(value);
        processes = fields.Texts("processes");
        conditions = fields.Texts("requires");
        fields.Finish();
      } else {
        processes = file_.TextsOf(value);
      }
      configuration.processes = ResolveAll("process", config_.processes, processes);
      configuration.requires_conditions = ResolveAll("condition", config_.conditions, conditions);
      RemoveDisabled(configuration);
      CheckComplete(name, configuration);
      config_.configurations.push_back(std::move(configuration));
    }
    if (config_.configurations.empty()) {
      file_.Error(file_.where(), "\"configurations\" names no configuration");
      return;
    }
    for (std::size_t i = 0; i < config_.sites.size(); ++i) {
      config_.sites[i].configuration =
          Resolve("configuration", config_.configurations, site_configurations_[i]).value_or(0);
    }
    ReadInitial();
    ReadGivenUp();
  }

  void ReadGivenUp() {
    YamlFields fields = file_.Map("on_given_up");
    for (const LocatedText& word : fields.Texts("command")) {
      config_.given_up.command.push_back(Fill(word, variables_));
    }
    if (fields.Has("configuration")) {
      const LocatedText name = fields.Text("configuration");
      config_.given_up.configuration = Resolve("configuration", config_.configurations, name);
    }
    fields.Finish();
  }

  void ReadInitial() {
    LocatedText name = file_.Text("initial", config_.configurations.front().name);
    if (!config_.sites.empty()) name = site_configurations_[config_.site];
    const auto initial = Resolve("configuration", config_.configurations, name);
    if (!initial) return;
    config_.initial = *initial;
    if (!config_.configurations[*initial].requires_conditions.empty()) {
      file_.Error(name.where, "configuration \"" + name.text +
                                  "\" requires a condition, so nothing can begin with it");
    }
  }

  void RemoveDisabled(Configuration& configuration) const {
    Indices& members = configuration.processes;
    const auto is_disabled = [this](std::size_t i) { return !config_.processes[i].is_enabled; };
    members.erase(std::remove_if(members.begin(), members.end(), is_disabled), members.end());
  }

  // A process would wait for ever for a dependency that is not part of its configuration.
  void CheckComplete(const LocatedText& name, const Configuration& configuration) {
    std::vector<bool> is_member(config_.processes.size());
    for (const std::size_t member : configuration.processes) is_member[member] = true;
    for (const std::size_t member : configuration.processes) {
      for (const std::size_t needed : config_.processes[member].depends) {
        if (is_member[needed]) continue;
        file_.Error(name.where, "configuration \"" + name.text + "\" has \"" +
                                    config_.processes[member].name + "\" but not \"" +
                                    config_.processes[needed].name + "\", which it depends on");
      }
    }
  }

  template <class Named>
  static std::optional<std::size_t> IndexOf(const std::vector<Named>& list,
                                            const std::string& name) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i].name == name) return i;
    }
    return std::nullopt;
  }

  template <class Named>
  std::optional<std::size_t> Resolve(const std::string& kind, const std::vector<Named>& list,
                                     const LocatedText& name) {
    const auto index = IndexOf(list, name.text);
    if (index) return index;
    file_.Error(name.where, "unknown " + kind + " \"" + name.text + "\"",
                advisor_.Advise(name.text, list, [](const Named& item) { return item.name; }));
    return std::nullopt;
  }

  template <class Named>
  Indices ResolveAll(const std::string& kind, const std::vector<Named>& list,
                     const std::vector<LocatedText>& names) {
    Indices indices;
    for (const LocatedText& name : names) {
      if (const auto index = Resolve(kind, list, name)) indices.push_back(*index);
    }
    return indices;
  }

  std::string Fill(const LocatedText& word, const Variables& variables) {
    std::string filled = FillVariables(word.text, variables, advisor_,
                                       [&](const std::string& message, const std::string& hint) {
                                         file_.Error(word.where, message, hint);
                                       });
    filled_ += filled.size();
    if (filled_ <= kMostFilled) return filled;
    file_.Error(word.where, "the texts of this file are too long with their variables filled in");
    return "";
  }

  Diagnostics& diagnostics_;
  Advisor advisor_;
  YamlFields file_;
  Variables variables_;     // with the site
  std::size_t filled_ = 0;  // bytes of texts so far
  bool readable_ = false;
  RobotConfig config_;
  RestartLimits limits_;  // of groups that do not say
  // Per process and per group, as written.
  std::vector<std::vector<LocatedText>> depends_, after_, group_depends_;
  std::vector<SourceLocation> where_, group_where_;
  std::vector<LocatedText> site_configurations_;
};

}  // namespace

RobotConfig LoadRobotConfig(const std::string& path, const Variables& variables,
                            Diagnostics& diagnostics) {
  return Loader(path, variables, diagnostics).Load();
}

}  // namespace coppice::robot::processes
