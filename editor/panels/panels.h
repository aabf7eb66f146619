// The tiles and bars of the editor. Each function draws one into `box` of the current ImGui window
// and registers its rows by path.
#ifndef COPPICE_EDITOR_PANELS_PANELS_H_
#define COPPICE_EDITOR_PANELS_PANELS_H_

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

/// Menus, the field that opens the command palette, the mode. "menu/file", "bar/palette".
void DrawTopBar(const Ui& ui, EditorState& state, const Box& box);

/// Whether there is a robot to tell of.
bool HasConnectionStrip(const EditorState& state);
/// One tab per robot with its state, and "strip/connect". A tab is "strip/HOST:PORT".
void DrawConnectionStrip(const Ui& ui, EditorState& state, const Box& box);

/// What is on the canvas, and buttons for it. "canvasbar/tb", "canvasbar/lr", "canvasbar/fit".
void DrawCanvasBar(const Ui& ui, EditorState& state, const Box& box);

/// Files and their trees. "project/FILE", "project/FILE/TREE".
void DrawProject(const Ui& ui, EditorState& state, const Box& box);

/// The shown tree as rows, with status and seconds. "outline/1.2".
void DrawOutline(const Ui& ui, EditorState& state, const Box& box);

/// The node types that can be added. "types/TYPE", "types/filter".
void DrawTypes(const Ui& ui, EditorState& state, const Box& box);

/// Everything about the selected node. "inspector/port/NAME".
void DrawInspector(const Ui& ui, EditorState& state, const Box& box);

/// Values on the robot, by blackboard. "blackboard/SCOPE/KEY".
void DrawBlackboard(const Ui& ui, EditorState& state, const Box& box);

/// What is wrong with the files and with the connection. "problems/0".
void DrawProblems(const Ui& ui, EditorState& state, const Box& box);

/// Where the robot stands: how to go on, below the node. "stop/continue".
void DrawStopBar(const Ui& ui, EditorState& state, const Box& canvas);
/// The banner over a simulation and what can be done with it. "sim/banner", "sim/tick".
void DrawSimulationBar(const Ui& ui, EditorState& state, const Box& box);

/// A frame around the canvas of a simulation, in its corner the file that says what happens by
/// chance, and below the selected leaf what it returns. "sim/chance_origin", "sim/success",
/// "sim/script".
void DrawSimulatedLeaf(const Ui& ui, EditorState& state, const Box& canvas);

/// Scenarios and how they went. "tests/0", with its first difference "tests/0/0", "tests/run".
void DrawTests(const Ui& ui, EditorState& state, const Box& box);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_PANELS_H_
