// What is open: files, robots, and the one tree that is shown. Knows nothing of windows and
// colours.
#ifndef COPPICE_EDITOR_CORE_WORKSPACE_H_
#define COPPICE_EDITOR_CORE_WORKSPACE_H_

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "editor/canvas/tree_view.h"
#include "editor/document/open_project.h"
#include "editor/live/live_snapshot.h"
#include "editor/scene/node_models.h"

namespace coppice::editor {

struct OpenFile {
  std::string path;
  std::shared_ptr<const Forest> forest;
  std::shared_ptr<const NodeModels> models;
  std::vector<Diagnostic> problems;       ///< of reading, then of checking
  std::vector<Diagnostic> read_problems;  ///< of reading alone
  std::string text;                       ///< of a file that cannot be parsed; else empty
  bool is_stale = false;                  ///< the text is malformed; forest is what it was before
};

/// An element of a file that is being edited.
struct ElementPlace {
  std::string path;
  ElementIndex element = 0;
};

/// A blackboard value with the time of its last change, in seconds of the editor.
struct ShownValueState {
  std::string value;
  double changed_at = -1e9;
};
using BoardHistory = std::map<std::string, std::map<std::string, ShownValueState>>;

struct Robot {
  std::unique_ptr<LiveSource> source;
  std::shared_ptr<const LiveSnapshot> snapshot;  ///< never null
  std::shared_ptr<const LiveTree> tree;          ///< the one that `models` and the view belong to
  std::shared_ptr<const NodeModels> models;
  BoardHistory boards;  ///< by blackboard, by key
};

class Workspace {
 public:
  /// Sizes of the nodes of a scene at zoom 1.
  using Measure = std::function<std::vector<Point>(const Scene&)>;

  explicit Workspace(Measure measure) : measure_(std::move(measure)) {}

  /// Opens a file, or reads it again if it is open, and shows its main tree. False if there is
  /// nothing to show; the problems tell why.
  bool Open(const std::string& path, double now);
  /// Makes a file that is not on the disk yet, with one empty tree, and shows it. Returns its path.
  std::string New(double now);
  /// Adds node models from a file; what is wrong goes to the problems.
  void AddModels(const std::string& path);
  /// Looks at the disk at once; Update does it every second.
  void Reload(double now);

  /// The files as they are being edited. After a change call Refresh.
  OpenProject& project() { return project_; }
  const OpenProject& project() const { return project_; }

  /// Shows what has changed in project() since the last time. The checker follows a little later.
  void Refresh(double now);
  /// The file has another path from now on.
  void Rename(const std::string& path, const std::string& new_path);

  void AddRobot(std::unique_ptr<LiveSource> source);

  /// Takes the newest snapshots of all robots, looks at the disk, checks what was changed. Once per
  /// frame.
  void Update(double now);
  /// What the last Updates found on the disk that the user should know; empty: nothing.
  std::string TakeNews() { return std::exchange(news_, {}); }
  /// Seconds until Update has something to do for files; infinity: nothing.
  double NextUpdateIn(double now) const;
  /// Checks what waits to be checked.
  void CheckNow();

  void ShowFileTree(std::size_t file, int tree, double now);
  void ShowRobot(std::size_t robot);
  /// The next robot, from a file too; without robots nothing changes.
  void ShowNextRobot();

  const std::vector<OpenFile>& files() const { return files_; }
  const std::vector<Robot>& robots() const { return robots_; }
  const std::vector<Diagnostic>& model_problems() const { return model_problems_; }

  /// The tree that is shown, null if there is none. Its scene is not empty.
  TreeView* view() { return view_; }
  const Forest* forest() const;
  const Robot* robot() const { return robot_ < 0 ? nullptr : &robots_[Index(robot_)]; }
  const LiveSnapshot* live() const { return robot() ? robot()->snapshot.get() : nullptr; }
  const OpenFile* file() const { return file_ < 0 ? nullptr : &files_[Index(file_)]; }
  int tree() const { return tree_; }  ///< of forest(); -1: none

  /// Every tree is laid out this way from now on.
  void SetOrientation(Orientation orientation, double now);
  Orientation orientation() const { return orientation_; }

  /// The element of project() that the scene node stands for; nothing on a robot and in a file
  /// whose text is malformed.
  std::optional<ElementPlace> PlaceOf(const SceneNode& node) const;
  /// The <BehaviorTree> that is shown.
  std::optional<ElementPlace> ShownTree() const;
  std::string ShownTreeId() const;

  /// Selects these elements, by offset, in the shown tree or else in the one that has the first.
  void SelectPlaces(const std::vector<Place>& places, double now);

  /// Selects the element with that number in that document, if the shown tree has it.
  bool SelectElement(const Document& document, ElementIndex element);

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  static std::size_t Index(int number) { return static_cast<std::size_t>(number); }
  OpenFile Load(const std::string& path);
  void Renew(std::size_t file, double now);
  void CheckAll();
  void LookAtDisk(double now);
  bool IsInShownTree(const Place& place) const;
  bool ShowTreeOf(const Place& place, double now);
  std::vector<std::uint32_t> NodesAt(const std::vector<Place>& places) const;
  void UpdateRobot(Robot& robot, double now);
  TreeView* ViewOf(const std::string& key, const Forest& forest, int tree, const NodeModels& models,
                   double now, bool renew);

  Measure measure_;
  OpenProject project_;
  std::uint64_t shown_version_ = 0;  // of project_
  std::string news_;
  double check_at_ = kNever;
  double look_at_ = kNever;
  std::vector<OpenFile> files_;
  std::vector<Robot> robots_;
  NodeModels models_;                    // known for all files
  std::vector<Project> model_projects_;  // the same, for the checker
  std::vector<Diagnostic> model_problems_;
  std::map<std::string, std::unique_ptr<TreeView>> views_;
  std::map<const TreeView*, std::shared_ptr<const void>> alive_;  // what the scenes point into
  Orientation orientation_ = Orientation::kTopToBottom;
  TreeView* view_ = nullptr;
  int file_ = -1;
  int robot_ = -1;
  int tree_ = -1;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_CORE_WORKSPACE_H_
