#include <dlfcn.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <utility>

#include "behaviortree_cpp/bt_factory.h"
#include "behaviortree_cpp/utils/shared_library.h"
#include "behaviortree_cpp/utils/wildcards.hpp"
#include "bt_core/compat/built_ins.h"
#include "bt_core/compat/shell.h"
#include "bt_core/compat/tree_maker.h"
#include "bt_core/engine/program.h"

namespace BT {
namespace {

using coppice::Diagnostics;
using coppice::Document;
using coppice::Project;

// Problems that do not keep a tree from running.
void TellWarnings(const Diagnostics& diagnostics) {
  if (!diagnostics.all().empty()) std::cerr << diagnostics.ToString();
}

}  // namespace

struct BehaviorTreeFactory::PImpl {
  std::unordered_map<std::string, NodeBuilder> builders;
  std::unordered_map<std::string, TreeNodeManifest> manifests;
  std::set<std::string> builtin_ids;
  std::map<std::string, std::string> aliases;  // ID -> built-in ID
  std::shared_ptr<ScriptingEnumsRegistry> enums = std::make_shared<ScriptingEnumsRegistry>();
  std::unordered_map<std::string, SubstitutionRule> rules;
  std::shared_ptr<PolymorphicCastRegistry> casts = std::make_shared<PolymorphicCastRegistry>();

  // What was registered: files by their path, texts by a name of their own.
  std::vector<std::string> sources;
  std::map<std::string, std::string> texts;

  std::shared_ptr<const coppice::Registry> registry;  // null: to be made anew

  std::shared_ptr<const coppice::Registry> Registry() {
    if (registry) return registry;
    auto made = std::make_shared<coppice::Registry>();
    for (const auto& [id, manifest] : manifests) {
      if (builtin_ids.count(id) == 0 && aliases.count(id) == 0) {
        internal::AddShells(*made, manifest);
      }
    }
    for (const auto& [id, built_in] : aliases) made->AddAlias(id, built_in);
    for (const auto& [name, value] : *enums) made->AddScriptConstant(name, value);
    made->MakeScriptConstantsReal();
    return registry = std::move(made);
  }

  std::string AddText(const std::string& text) {
    const std::string name = "text " + std::to_string(texts.size() + 1);
    texts[name] = text;
    return name;
  }

  std::shared_ptr<const Project> Read(const std::vector<std::string>& from) const {
    Diagnostics diagnostics;
    const auto read = [this](const std::string& path, Diagnostics& problems) {
      const auto text = texts.find(path);
      return text == texts.end() ? Document::FromFile(path, problems)
                                 : Document::FromText(text->second, path, problems);
    };
    std::optional<Project> project = Project::FromFiles(from, diagnostics, {}, read);
    if (!project || diagnostics.has_errors()) throw RuntimeError(diagnostics.ToString());
    return std::make_shared<const Project>(*std::move(project));
  }

  Tree Create(const BehaviorTreeFactory& factory, const std::vector<std::string>& from,
              const std::string& tree_name, Blackboard::Ptr blackboard) {
    if (!blackboard) throw RuntimeError("A tree needs a blackboard: Blackboard::create()");
    Diagnostics diagnostics;
    const auto outer =
        blackboard->parent() ? coppice::OuterKeys::kApart : coppice::OuterKeys::kOfMainTree;
    const auto program = coppice::Compile(Read(from), Registry(), diagnostics, tree_name, outer);
    if (!program) throw RuntimeError(diagnostics.ToString());
    TellWarnings(diagnostics);
    Tree tree;
    tree.manifests = manifests;
    internal::Making making{factory, enums,
                            [this](const auto&... names) { return FindRule(names...); }};
    internal::TreeMaker maker(making, program, std::move(blackboard));
    tree.run_ = maker.Make(tree.subtrees, tree.manifests);
    tree.uid_counter_ = static_cast<uint16_t>(program->nodes.size());
    return tree;
  }

  const SubstitutionRule* FindRule(const std::string& name, const std::string& id,
                                   const std::string& path) const {
    for (const auto& [filter, rule] : rules) {
      if (filter == name || filter == id || wildcards_match(path, filter)) return &rule;
    }
    return nullptr;
  }
};

BehaviorTreeFactory::BehaviorTreeFactory() : _p(std::make_unique<PImpl>()) {
  const coppice::Registry built_in;
  for (const auto& [id, entry] : built_in.entries()) {
    _p->manifests.emplace(id, internal::ManifestOf(entry.manifest));
    _p->builtin_ids.insert(id);
    _p->builders[id] = [id = id](const std::string& name, const NodeConfig& config) {
      static const coppice::Registry registry;
      return internal::MakeBuiltIn(*registry.Find(id), name, config);
    };
  }
}
BehaviorTreeFactory::~BehaviorTreeFactory() = default;
BehaviorTreeFactory::BehaviorTreeFactory(BehaviorTreeFactory&&) noexcept = default;
BehaviorTreeFactory& BehaviorTreeFactory::operator=(BehaviorTreeFactory&&) noexcept = default;

// ---- Node types.

bool BehaviorTreeFactory::unregisterBuilder(const std::string& id) {
  if (_p->builtin_ids.count(id) > 0) {
    throw LogicError("You can not remove the builtin registration ID [", id, "]");
  }
  _p->registry = nullptr;
  _p->builders.erase(id);
  _p->aliases.erase(id);
  return _p->manifests.erase(id) > 0;
}

void BehaviorTreeFactory::registerBuilder(const TreeNodeManifest& manifest,
                                          const NodeBuilder& builder) {
  const std::string& id = manifest.registration_ID;
  if (_p->manifests.count(id) > 0) {
    throw BehaviorTreeException("ID [", id, "] already registered");
  }
  try {
    coppice::Registry trial;
    internal::AddShells(trial, manifest);
  } catch (const std::invalid_argument& error) {
    throw RuntimeError(error.what());
  }
  _p->registry = nullptr;
  _p->manifests.emplace(id, manifest);
  _p->builders.emplace(id, builder);
}

void BehaviorTreeFactory::RegisterAlias(const std::string& id, const std::string& built_in) {
  if (_p->manifests.count(id) > 0) {
    throw BehaviorTreeException("ID [", id, "] already registered");
  }
  TreeNodeManifest manifest = _p->manifests.at(built_in);
  manifest.registration_ID = id;
  _p->registry = nullptr;
  _p->manifests.emplace(id, std::move(manifest));
  _p->builders.emplace(id, _p->builders.at(built_in));
  _p->aliases[id] = built_in;
}

void BehaviorTreeFactory::registerSimpleAction(const std::string& id,
                                               const SimpleActionNode::TickFunctor& tick_functor,
                                               PortsList ports) {
  registerBuilder({NodeType::ACTION, id, std::move(ports), {}},
                  [=](const std::string& name, const NodeConfig& config) {
                    return std::make_unique<SimpleActionNode>(name, tick_functor, config);
                  });
}
void BehaviorTreeFactory::registerSimpleCondition(
    const std::string& id, const SimpleConditionNode::TickFunctor& tick_functor, PortsList ports) {
  registerBuilder({NodeType::CONDITION, id, std::move(ports), {}},
                  [=](const std::string& name, const NodeConfig& config) {
                    return std::make_unique<SimpleConditionNode>(name, tick_functor, config);
                  });
}
void BehaviorTreeFactory::registerSimpleDecorator(
    const std::string& id, const SimpleDecoratorNode::TickFunctor& tick_functor, PortsList ports) {
  registerBuilder({NodeType::DECORATOR, id, std::move(ports), {}},
                  [=](const std::string& name, const NodeConfig& config) {
                    return std::make_unique<SimpleDecoratorNode>(name, tick_functor, config);
                  });
}

const std::unordered_map<std::string, NodeBuilder>& BehaviorTreeFactory::builders() const {
  return _p->builders;
}
const std::unordered_map<std::string, TreeNodeManifest>& BehaviorTreeFactory::manifests() const {
  return _p->manifests;
}
const std::set<std::string>& BehaviorTreeFactory::builtinNodes() const { return _p->builtin_ids; }

std::shared_ptr<const coppice::Registry> BehaviorTreeFactory::registry() const {
  return _p->Registry();
}

void BehaviorTreeFactory::addMetadataToManifest(const std::string& node_id,
                                                const KeyValueVector& metadata) {
  const auto found = _p->manifests.find(node_id);
  if (found == _p->manifests.end()) {
    throw std::runtime_error("addMetadataToManifest: wrong ID");
  }
  found->second.metadata = metadata;
}

std::unique_ptr<TreeNode> BehaviorTreeFactory::instantiateTreeNode(const std::string& name,
                                                                   const std::string& id,
                                                                   const NodeConfig& config) const {
  std::unique_ptr<TreeNode> node;
  if (const SubstitutionRule* const rule = _p->FindRule(name, id, config.path)) {
    if (const auto* const other = std::get_if<std::string>(rule)) {
      const auto builder = _p->builders.find(*other);
      if (builder == _p->builders.end()) {
        throw RuntimeError("Substituted Node ID [", *other, "] not found");
      }
      node = builder->second(name, config);
    } else if (const auto* const test = std::get_if<TestNodeConfig>(rule)) {
      node = std::make_unique<TestNode>(name, config, std::make_shared<TestNodeConfig>(*test));
    } else {
      node = std::make_unique<TestNode>(name, config,
                                        std::get<std::shared_ptr<TestNodeConfig>>(*rule));
    }
  } else {
    const auto builder = _p->builders.find(id);
    if (builder == _p->builders.end()) {
      throw RuntimeError("BehaviorTreeFactory: ID [", id, "] not registered");
    }
    node = builder->second(name, config);
  }
  if (!node) throw RuntimeError("BehaviorTreeFactory: the builder of [", id, "] has made nothing");
  node->setRegistrationID(id);
  node->config().enums = _p->enums;
  return node;
}

// ---- Trees.

void BehaviorTreeFactory::registerBehaviorTreeFromFile(const std::filesystem::path& filename) {
  std::vector<std::string> sources = _p->sources;
  sources.push_back(filename.string());
  _p->Read(sources);
  _p->sources = std::move(sources);
}

void BehaviorTreeFactory::registerBehaviorTreeFromText(const std::string& xml_text) {
  std::vector<std::string> sources = _p->sources;
  sources.push_back(_p->AddText(xml_text));
  _p->Read(sources);
  _p->sources = std::move(sources);
}

std::vector<std::string> BehaviorTreeFactory::registeredBehaviorTrees() const {
  std::vector<std::string> ids;
  if (_p->sources.empty()) return ids;
  const std::shared_ptr<const Project> project = _p->Read(_p->sources);
  for (const auto& [id, tree] : project->trees()) ids.push_back(id);
  return ids;
}

void BehaviorTreeFactory::clearRegisteredBehaviorTrees() {
  _p->sources.clear();
  _p->texts.clear();
}

Tree BehaviorTreeFactory::createTreeFromText(const std::string& text, Blackboard::Ptr blackboard) {
  return _p->Create(*this, {_p->AddText(text)}, "", std::move(blackboard));
}
Tree BehaviorTreeFactory::createTreeFromFile(const std::filesystem::path& file_path,
                                             Blackboard::Ptr blackboard) {
  return _p->Create(*this, {file_path.string()}, "", std::move(blackboard));
}
Tree BehaviorTreeFactory::createTree(const std::string& tree_name, Blackboard::Ptr blackboard) {
  if (_p->sources.empty()) throw RuntimeError("no tree \"", tree_name, "\": none is registered");
  return _p->Create(*this, _p->sources, tree_name, std::move(blackboard));
}

// ---- Scripts and casts.

void BehaviorTreeFactory::registerScriptingEnum(StringView name, int value) {
  const auto [at, inserted] = _p->enums->emplace(name, value);
  if (!inserted && at->second != value) {
    throw LogicError("Registering the enum [", name, "] twice with different values, first ",
                     std::to_string(at->second), " and later ", std::to_string(value));
  }
  _p->registry = nullptr;
}

PolymorphicCastRegistry& BehaviorTreeFactory::polymorphicCastRegistry() { return *_p->casts; }
const PolymorphicCastRegistry& BehaviorTreeFactory::polymorphicCastRegistry() const {
  return *_p->casts;
}
std::shared_ptr<PolymorphicCastRegistry> BehaviorTreeFactory::polymorphicCastRegistryPtr() const {
  return _p->casts;
}

// ---- Substitution.

void BehaviorTreeFactory::addSubstitutionRule(StringView filter, SubstitutionRule rule) {
  _p->rules[std::string(filter)] = std::move(rule);
}
void BehaviorTreeFactory::clearSubstitutionRules() { _p->rules.clear(); }
const std::unordered_map<std::string, BehaviorTreeFactory::SubstitutionRule>&
BehaviorTreeFactory::substitutionRules() const {
  return _p->rules;
}

namespace {

TestNodeConfig ReadTestNode(const nlohmann::json& json) {
  TestNodeConfig config;
  config.return_status = convertFromString<NodeStatus>(json.at("return_status").get<std::string>());
  config.async_delay = std::chrono::milliseconds(json.value("async_delay", 0));
  config.post_script = json.value("post_script", "");
  config.success_script = json.value("success_script", "");
  config.failure_script = json.value("failure_script", "");
  config.return_status_script = json.value("return_status_script", "");
  return config;
}

}  // namespace

void BehaviorTreeFactory::loadSubstitutionRuleFromJSON(const std::string& json_text) {
  const auto json = nlohmann::json::parse(json_text);
  std::unordered_map<std::string, TestNodeConfig> configs;
  if (json.contains("TestNodeConfigs")) {
    for (const auto& [name, test] : json.at("TestNodeConfigs").items()) {
      configs.emplace(name, ReadTestNode(test));
    }
  }
  for (const auto& [filter, target] : json.at("SubstitutionRules").items()) {
    const auto name = target.get<std::string>();
    const auto config = configs.find(name);
    if (config == configs.end()) {
      addSubstitutionRule(filter, name);
    } else {
      addSubstitutionRule(filter, config->second);
    }
  }
}

// ---- Plugins.

void BehaviorTreeFactory::registerFromPlugin(const std::string& file_path) {
  SharedLibrary library(file_path);
  if (!library.hasSymbol(PLUGIN_SYMBOL)) {
    throw RuntimeError(file_path,
                       ": no BT_REGISTER_NODES in it; was it compiled with "
                       "BT_PLUGIN_EXPORT defined?");
  }
  using Register = void (*)(BehaviorTreeFactory&);
  reinterpret_cast<Register>(library.getSymbol(PLUGIN_SYMBOL))(*this);
}

namespace {

std::vector<std::string> LinesOf(const char* command) {
  std::vector<std::string> lines;
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command, "r"), &pclose);
  char line[4096];
  while (pipe && fgets(line, sizeof line, pipe.get())) lines.emplace_back(line);
  return lines;
}

}  // namespace

void BehaviorTreeFactory::registerFromROSPlugins() {
  const auto lines = LinesOf("rospack plugins --attrib=bt_lib_plugin behaviortree_cpp_v3");
  for (std::string line : lines) {
    line.erase(line.find_last_not_of(" \n") + 1);
    const std::size_t blank = line.find(' ');
    const std::string path = blank == std::string::npos ? line : line.substr(blank + 1);
    registerFromPlugin(SharedLibrary::getOSName(path));
  }
}

void SharedLibrary::load(const std::string& path, int) {
  handle_ = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle_) throw RuntimeError("Could not load library: ", dlerror());
  path_ = path;
}
void SharedLibrary::unload() { handle_ = nullptr; }
void* SharedLibrary::findSymbol(const std::string& name) {
  return handle_ ? dlsym(handle_, name.c_str()) : nullptr;
}
void* SharedLibrary::getSymbol(const std::string& name) {
  void* const symbol = findSymbol(name);
  if (!symbol) throw RuntimeError("[SharedLibrary::getSymbol]: can't find symbol ", name);
  return symbol;
}

}  // namespace BT
