#include "editor/core/workspace.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

#include "bt_core/engine/program.h"

namespace coppice::editor {
namespace {

// Stands for a leaf that only the robot's program knows.
class UnknownLeaf : public SyncAction {
 public:
  Status Run() override { return Status::kSuccess; }
};

// Empty if it cannot be read; that is a problem already.
std::string ReadText(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  if (stream) text << stream.rdbuf();
  return text.str();
}

void AddOnce(std::vector<Diagnostic>& all, const std::vector<Diagnostic>& more) {
  for (const Diagnostic& one : more) {
    const std::string text = ToString(one);
    const bool known = std::any_of(all.begin(), all.end(),
                                   [&](const Diagnostic& d) { return ToString(d) == text; });
    if (!known) all.push_back(one);
  }
}

// Compiles every tree, which finds what reading alone does not.
void Check(const Forest& forest, std::vector<Diagnostic>& problems) {
  if (!forest.project()) return;
  auto registry = std::make_shared<Registry>();
  registry->SetFallback([](const std::string&) { return std::make_unique<UnknownLeaf>(); });
  for (const auto& [id, definition] : forest.project()->trees()) {
    Diagnostics diagnostics;
    Compile(forest.project(), registry, diagnostics, id);
    AddOnce(problems, diagnostics.all());
  }
}

std::vector<std::string> ShownBoards(const Scene& scene) {
  std::vector<std::string> boards = scene.scopes;
  boards.erase(std::remove(boards.begin(), boards.end(), ""), boards.end());
  return boards;
}

}  // namespace

OpenFile Workspace::Load(const std::string& path) const {
  OpenFile file;
  file.path = path;
  Diagnostics diagnostics;
  file.forest = std::make_shared<const Forest>(Forest::FromFile(path, diagnostics));
  file.problems = diagnostics.all();
  Check(*file.forest, file.problems);
  auto models = std::make_shared<NodeModels>(models_);
  for (const Document* document : file.forest->documents()) models->AddFrom(*document);
  file.models = std::move(models);
  if (file.forest->documents().empty()) file.text = ReadText(path);
  return file;
}

bool Workspace::Open(const std::string& path, double now) {
  std::size_t at = 0;
  while (at < files_.size() && files_[at].path != path) ++at;
  const bool renew = at < files_.size();
  OpenFile loaded = Load(path);
  if (renew) {
    // Scenes keep what they point into alive; the others are renewed when they are shown.
    files_[at] = std::move(loaded);
    const std::string prefix = "file:" + path + ":";
    for (auto& [key, view] : views_) {
      if (key.compare(0, prefix.size(), prefix) != 0) continue;
      const int tree = files_[at].forest->Find(key.substr(prefix.size()));
      if (tree >= 0) {
        ViewOf(key, *files_[at].forest, tree, *files_[at].models, now, true);
        alive_[view.get()] = std::make_shared<OpenFile>(files_[at]);
      }
    }
  } else {
    files_.push_back(std::move(loaded));
  }
  const int main = files_[at].forest->main_tree();
  if (renew && file_ == static_cast<int>(at) && tree_ >= 0 && view_) {
    const int same = files_[at].forest->Find(view_->scene()->tree_id);
    ShowFileTree(at, same >= 0 ? same : main, now);
  } else {
    ShowFileTree(at, main, now);
  }
  return main >= 0;
}

void Workspace::AddModels(const std::string& path) {
  Diagnostics diagnostics;
  const std::optional<Document> document = Document::FromFile(path, diagnostics);
  if (document) models_.AddFrom(*document);
  AddOnce(model_problems_, diagnostics.all());
}

void Workspace::Reload(double now) {
  if (file_ >= 0) Open(std::string(files_[Index(file_)].path), now);
}

void Workspace::AddRobot(std::unique_ptr<LiveSource> source) {
  Robot robot;
  robot.snapshot = source->snapshot();
  robot.source = std::move(source);
  robots_.push_back(std::move(robot));
  if (robots_.size() == 1) ShowRobot(0);
}

void Workspace::Update(double now) {
  for (Robot& robot : robots_) UpdateRobot(robot, now);
  if (robot_ < 0) return;
  Robot& robot = robots_[Index(robot_)];
  if (!robot.tree) {
    view_ = nullptr;
    tree_ = -1;
    return;
  }
  tree_ = robot.tree->forest.main_tree();
  const std::string key = "robot:" + robot.source->endpoint();
  const auto known = views_.find(key);
  const bool renew = known == views_.end() || alive_[known->second.get()] != robot.tree;
  view_ = ViewOf(key, robot.tree->forest, tree_, *robot.models, now, renew);
  if (!renew || !view_) return;
  alive_[view_] = robot.tree;
  robot.source->Watch(ShownBoards(*view_->scene()));
}

void Workspace::UpdateRobot(Robot& robot, double now) {
  auto snapshot = robot.source->snapshot();
  if (snapshot == robot.snapshot && (robot.tree || !snapshot->tree)) return;
  robot.snapshot = std::move(snapshot);
  if (robot.snapshot->tree && robot.snapshot->tree != robot.tree) {
    robot.tree = robot.snapshot->tree;
    auto models = std::make_shared<NodeModels>(models_);
    for (const Document* document : robot.tree->forest.documents()) models->AddFrom(*document);
    // A scene that is about to be replaced still points into the old models.
    robot.models = std::move(models);
    robot.boards.clear();
  }
  for (const Board& board : robot.snapshot->boards) {
    auto& known = robot.boards[board.name];
    for (const BoardEntry& entry : board.entries) {
      const bool is_new = known.count(entry.key) == 0;
      ShownValueState& shown = known[entry.key];
      if (!is_new && shown.value != entry.value) shown.changed_at = now;
      shown.value = entry.value;
    }
  }
}

TreeView* Workspace::ViewOf(const std::string& key, const Forest& forest, int tree,
                            const NodeModels& models, double now, bool renew) {
  std::unique_ptr<TreeView>& view = views_[key];
  if (!view) {
    view = std::make_unique<TreeView>();
    renew = true;
  }
  if (renew) {
    auto scene = std::make_shared<Scene>(BuildScene(forest, tree, models));
    std::vector<Point> sizes = measure_(*scene);
    view->SetScene(std::move(scene), std::move(sizes), now);
  }
  view->SetOrientation(orientation_, now);
  return view->scene()->nodes.empty() ? nullptr : view.get();
}

void Workspace::ShowFileTree(std::size_t file, int tree, double now) {
  robot_ = -1;
  file_ = static_cast<int>(file);
  tree_ = tree;
  view_ = nullptr;
  if (tree < 0) return;
  const OpenFile& open = files_[file];
  const std::string key = "file:" + open.path + ":" + open.forest->trees()[Index(tree)].id;
  view_ = ViewOf(key, *open.forest, tree, *open.models, now, false);
  if (view_ && !alive_[view_]) alive_[view_] = std::make_shared<OpenFile>(open);
}

void Workspace::ShowRobot(std::size_t robot) {
  if (robot >= robots_.size()) return;
  robot_ = static_cast<int>(robot);
  file_ = -1;
  view_ = nullptr;  // until the next Update
  tree_ = -1;
}

void Workspace::ShowNextRobot() {
  if (robots_.empty()) return;
  ShowRobot(Index(robot_ + 1) % robots_.size());
}

const Forest* Workspace::forest() const {
  if (robot_ >= 0) {
    const Robot& shown = robots_[Index(robot_)];
    return shown.tree ? &shown.tree->forest : nullptr;
  }
  return file_ >= 0 ? files_[Index(file_)].forest.get() : nullptr;
}

void Workspace::SetOrientation(Orientation orientation, double now) {
  orientation_ = orientation;
  for (auto& [key, view] : views_) view->SetOrientation(orientation, now);
}

bool Workspace::SelectElement(const Document& document, ElementIndex element) {
  if (!view_ || !forest()) return false;
  const Scene& scene = *view_->scene();
  for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
    const SceneNode& node = scene.nodes[i];
    if (node.element == element && forest()->documents()[node.document] == &document) {
      view_->Select(i);
      return true;
    }
  }
  return false;
}

}  // namespace coppice::editor
