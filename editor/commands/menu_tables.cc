// A right click has one table for all things: a row says which things its command is for. Lines
// stand between groups of which something is left.
#include "editor/commands/menu_tables.h"

#include "editor/commands/menus.h"

namespace coppice::editor {
namespace {

constexpr std::string_view kLine;

constexpr std::string_view kFile[] = {
    "file.new",    "file.open",    "file.recent",         "robot.known",
    "file.reload", "file.save",    "file.save_as",        kLine,
    "file.export", "file.compare", "file.stop_comparing", "file.unsaved",
    kLine,         "file.quit"};
constexpr std::string_view kEdit[] = {"edit.undo",
                                      "edit.redo",
                                      "edit.history",
                                      kLine,
                                      "edit.cut",
                                      "edit.copy",
                                      "edit.paste",
                                      "edit.paste_after",
                                      "edit.duplicate",
                                      "edit.select_all",
                                      kLine,
                                      "edit.add",
                                      "edit.rename",
                                      "edit.change_type",
                                      "edit.disable",
                                      "edit.delete",
                                      "edit.delete_only",
                                      kLine,
                                      "edit.find",
                                      "edit.find_next",
                                      "edit.find_previous",
                                      "edit.replace",
                                      "key.rename",
                                      "edit.xml",
                                      kLine,
                                      "difference.next",
                                      "difference.previous"};
constexpr std::string_view kTree[] = {
    "tree.new",    "tree.rename",     "tree.delete", kLine, "tree.extract",
    "tree.inline", "tree.definition", "tree.usages", kLine, "file.include"};
constexpr std::string_view kView[] = {"view.grow_by_itself",
                                      "view.top_to_bottom",
                                      "view.left_to_right",
                                      kLine,
                                      "view.fit_all",
                                      "view.fit_selection",
                                      "view.zoom_100",
                                      kLine,
                                      "view.compact",
                                      "view.layered",
                                      "view.stacked",
                                      "view.wrapped",
                                      kLine,
                                      "view.ports_by_itself",
                                      "view.ports_all",
                                      "view.ports_none",
                                      kLine,
                                      "tree.collapse",
                                      "tree.open_subtrees",
                                      "tree.close_subtrees",
                                      kLine,
                                      "view.scale",
                                      "view.wheel_zooms",
                                      "palette.dark",
                                      "palette.light",
                                      "palette.colourblind",
                                      "view.reduce_motion"};
constexpr std::string_view kScale[] = {
    "scale.larger", "scale.smaller", "scale.as_screen", kLine,       "scale.75",  "scale.100",
    "scale.125",    "scale.150",     "scale.175",       "scale.200", "scale.250", "scale.300"};
constexpr std::string_view kTiles[] = {
    "tile.project", "tile.outline",  "tile.types",      "tile.inspector", "tile.blackboard",
    "tile.xml",     "tile.problems", "tile.tests",      "tile.run",       "tile.timeline",
    "tile.minimap", kLine,           "view.canvas_only"};
constexpr std::string_view kRobot[] = {"robot.connect",
                                       "robot.known",
                                       "robot.forget",
                                       "robot.search",
                                       "robot.next",
                                       "run.close",
                                       kLine,
                                       "run.pause",
                                       "run.continue",
                                       "run.step_tick",
                                       "run.step_node",
                                       kLine,
                                       "run.breakpoint",
                                       "run.breakpoint_enable",
                                       "run.breakpoint_condition",
                                       "run.breakpoint_path",
                                       "run.log_point",
                                       kLine,
                                       "run.force_success",
                                       "run.force_failure",
                                       "run.force_running",
                                       "run.force_skipped",
                                       "run.delay",
                                       "run.clear_faults"};
constexpr std::string_view kRun[] = {"run.back",
                                     "run.forward",
                                     "run.change_before",
                                     "run.next_change",
                                     "run.begin",
                                     "run.now",
                                     "run.play",
                                     "run.faster",
                                     "run.slower",
                                     kLine,
                                     "run.why",
                                     "run.running",
                                     "run.robots",
                                     "run.hooks",
                                     "run.pictures",
                                     "run.log",
                                     "run.statistics",
                                     "run.comparison",
                                     "run.table",
                                     "run.coverage",
                                     kLine,
                                     "run.bookmark",
                                     "run.bookmark_text",
                                     "run.bookmarks",
                                     kLine,
                                     "run.follow",
                                     "run.heat",
                                     "run.pin",
                                     "blackboard.selection",
                                     "blackboard.write",
                                     kLine,
                                     "run.save",
                                     "run.save_tree",
                                     "run.save_test"};
constexpr std::string_view kSimulate[] = {
    "sim.start",   "sim.end",     "sim.restart",   "sim.again",      kLine,        "sim.play",
    "sim.tick",    "sim.change",  "sim.back",      "sim.faster",     "sim.slower", kLine,
    "sim.success", "sim.failure", "sim.running",   "sim.skipped",    "sim.script", "sim.set",
    kLine,         "sim.tests",   "sim.save_test", "sim.save_record"};
constexpr std::string_view kHelp[] = {"help.palette", "help.keys",      kLine,          "help.tour",
                                      "example.tree", "example.record", "example.robot"};

struct BarRows {
  std::string_view name;
  const std::string_view* rows;
  std::size_t count;
};

template <std::size_t kCount>
constexpr BarRows Of(std::string_view name, const std::string_view (&rows)[kCount]) {
  return {name, rows, kCount};
}

constexpr BarRows kBar[] = {Of("file", kFile),       Of("edit", kEdit),         Of("tree", kTree),
                            Of("view", kView),       Of("tiles", kTiles),       Of("robot", kRobot),
                            Of("run", kRun),         Of("simulate", kSimulate), Of("help", kHelp),
                            Of("view.scale", kScale)};

// Things that one can click on.
enum Thing : unsigned {
  kOnNode = 1,
  kOnLine = 2,
  kOnCanvas = 4,
  kOutlineRow = 8,
  kOnKey = 16,
  kOnLane = 32,
  kOnTree = 64,
  kOnTab = 128,
  kEverything = 255
};

// A row with one of these is only for what is shown then.
constexpr unsigned kInFile = 256;
constexpr unsigned kInRun = 512;

struct NamedThing {
  std::string_view menu;
  Thing thing;
};
constexpr NamedThing kThings[] = {{menu::kNode, kOnNode},     {menu::kLine, kOnLine},
                                  {menu::kCanvas, kOnCanvas}, {menu::kRow, kOutlineRow},
                                  {menu::kKey, kOnKey},       {menu::kLane, kOnLane},
                                  {menu::kTree, kOnTree},     {menu::kTab, kOnTab}};

struct ThingRow {
  std::string_view command;
  unsigned things;
};
constexpr ThingRow kOfThings[] = {
    {"edit.add", kOnNode | kOutlineRow | kOnCanvas | kInFile},
    {"edit.add_after", kOnNode | kOutlineRow | kInFile},
    {"edit.add_around", kOnNode | kOutlineRow | kOnLine | kInFile},
    {"edit.rename", kOnNode | kOutlineRow | kInFile},
    {"edit.change_type", kOnNode | kOutlineRow | kInFile},
    {"edit.ports_here", kOnNode | kInFile},
    {"type.define", kOnNode | kOutlineRow | kOnCanvas | kOnTree | kInFile},
    {kLine, kEverything},
    {"edit.cut", kOnNode | kOutlineRow | kInFile},
    {"edit.copy", kOnNode | kOutlineRow},
    {"edit.paste", kOnNode | kOutlineRow | kOnCanvas | kInFile},
    {"edit.paste_after", kOnNode | kOutlineRow | kInFile},
    {"edit.duplicate", kOnNode | kOutlineRow | kInFile},
    {"edit.disable", kOnNode | kOutlineRow | kOnLine | kInFile},
    {"edit.delete", kOnNode | kOutlineRow | kOnLine | kInFile},
    {"edit.delete_only", kOnNode | kOutlineRow | kInFile},
    {kLine, kEverything},
    {"tree.extract", kOnNode | kOutlineRow | kOnLine | kInFile},
    {"tree.inline", kOnNode | kOutlineRow | kInFile},
    {"tree.definition", kOnNode | kOutlineRow | kOnLane},
    {"tree.usages", kOnNode | kOutlineRow | kOnTree},
    {"edit.xml", kOnNode | kOutlineRow | kInFile},
    {kLine, kEverything},
    {"tree.collapse", kOnNode | kOutlineRow | kOnLine},
    {"tree.collapse_others", kOnNode | kOutlineRow},
    {"view.fit_selection", kOnNode | kOutlineRow | kOnLine | kOnLane},
    {"edit.select_all", kOnCanvas},
    {"edit.undo", kOnCanvas | kInFile},
    {"edit.redo", kOnCanvas | kInFile},
    {"edit.find", kOnCanvas},
    {"view.fit_all", kOnCanvas | kOnTab},
    {"view.zoom_100", kOnCanvas},
    {"view.grow_by_itself", kOnCanvas},
    {"view.top_to_bottom", kOnCanvas},
    {"view.left_to_right", kOnCanvas},
    {"tree.open_subtrees", kOnCanvas},
    {"tree.close_subtrees", kOnCanvas},
    {"view.canvas_only", kOnCanvas},
    {kLine, kEverything},
    {"run.why", kOnNode | kOutlineRow | kOnLane | kInRun},
    {"run.change_before", kOnNode | kOnLane | kInRun},
    {"run.next_change", kOnNode | kOnLane | kInRun},
    {"run.pin", kOnLane | kInRun},
    {"run.bookmark", kOnLane | kInRun},
    {"run.statistics", kOnLane | kInRun},
    {"run.breakpoint", kOnNode | kOutlineRow | kOnLane},
    {"run.breakpoint_enable", kOnNode},
    {"run.breakpoint_condition", kOnNode | kOutlineRow},
    {"run.log_point", kOnNode | kOutlineRow},
    {"run.to_here", kOnNode | kOutlineRow | kInRun},
    {kLine, kEverything},
    {"sim.success", kOnNode | kInRun},
    {"sim.failure", kOnNode | kInRun},
    {"sim.running", kOnNode | kInRun},
    {"sim.script", kOnNode | kOutlineRow | kInRun},
    {kLine, kEverything},
    {"blackboard.write", kOnKey},
    {"key.copy", kOnKey},
    {"key.copy_value", kOnKey},
    {"blackboard.selection", kOnKey},
    {"run.table", kOnKey},
    {kLine, kEverything},
    {"tree.new", kOnTree | kOnCanvas | kInFile},
    {"tree.rename", kOnTree | kOnTab},
    {"tree.delete", kOnTree},
    {"sim.start", kOnTree | kOnTab | kOnCanvas | kInFile},
    {kLine, kEverything},
    {"file.save", kOnTree | kOnTab},
    {"file.save_as", kOnTree},
    {"file.include", kOnTree},
    {"run.save_tree", kOnTree | kOnTab | kOnCanvas | kInRun},
    {"file.export", kOnTree | kOnTab | kOnCanvas},
    {"file.compare", kOnTree | kOnTab},
    {kLine, kEverything},
    {"tab.next", kOnTab},
    {"tab.previous", kOnTab},
    {"tab.close_others", kOnTab},
    {"tab.close", kOnTab}};

std::vector<std::string_view> CommandsOf(Thing thing, bool in_run) {
  std::vector<std::string_view> commands;
  for (const ThingRow& row : kOfThings) {
    const bool elsewhere = row.things & (in_run ? kInFile : kInRun);
    if (!(row.things & thing) || elsewhere) continue;
    const bool is_line = row.command.empty();
    if (!is_line || (!commands.empty() && !commands.back().empty())) {
      commands.push_back(row.command);
    }
  }
  if (!commands.empty() && commands.back().empty()) commands.pop_back();
  return commands;
}

}  // namespace

std::vector<std::string_view> CommandsOf(std::string_view menu, bool in_run) {
  for (const BarRows& bar : kBar) {
    if (bar.name == menu) return {bar.rows, bar.rows + bar.count};
  }
  for (const NamedThing& named : kThings) {
    if (named.menu == menu) return CommandsOf(named.thing, in_run);
  }
  return {};
}

}  // namespace coppice::editor
