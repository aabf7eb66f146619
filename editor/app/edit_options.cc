#include "editor/app/edit_options.h"

#include <cstdio>

namespace coppice::editor {
namespace {

constexpr double kShortest = 0.001, kLongest = 1e9;  // s

bool ReadSize(const std::string& text, int& width, int& height) {
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2) return false;
  return width >= 320 && height >= 240 && width <= 16384 && height <= 16384;
}

}  // namespace

const Command& EditCommand() {
  static const Command command{
      "coppice edit",
      "open the graphical editor",
      {"[FILE...]", 0, kAnyNumber},
      R"(Shows behaviour trees: of files (.xml), live of robots that speak the Groot2
protocol, and of records of runs (.coppice, and .btlog of BehaviorTree.CPP).)",
      {CommandOption::Text("--connect", "HOST:PORT", "follow a robot; may be given several times"),
       CommandOption::Text("--models", "FILE",
                           "XML file with a <TreeNodesModel>; may be given several times"),
       CommandOption::OneOf("--palette", {"dark", "light", "colourblind"},
                            "else as the last time, at first dark"),
       CommandOption::Flag("--reduce-motion", "nothing pulses, walks or glides"),
       CommandOption::Text("--size", "WxH", "of the window; else 1280x800"),
       CommandOption::Text("--picture", "FILE.png", "save what the window shows, at the end"),
       CommandOption::Real("--every", "SECONDS", kShortest, kLongest,
                           "save the picture again and again"),
       CommandOption::Flag("--headless", "needs no display; use it with --picture"),
       CommandOption::Real("--for", "SECONDS", kShortest, kLongest, "end after that time")}};
  return command;
}

EditOptions ParseEditOptions(const std::vector<std::string>& arguments) {
  const Options given = ParseOptions(EditCommand(), arguments);
  EditOptions options;
  options.exit = given.exit;
  if (given.exit) return options;
  options.files = given.files;
  options.robots = given.GetAll("--connect");
  options.models = given.GetAll("--models");
  options.picture = given.Get("--picture");
  options.picture_every = given.Real("--every", 0);
  options.run_for = given.Real("--for", 0);
  options.headless = given.Has("--headless");
  options.reduce_motion = given.Has("--reduce-motion");
  options.palette = PaletteFromString(given.Get("--palette"));
  const std::string size = given.Get("--size");
  if (!size.empty() && !ReadSize(size, options.width, options.height)) {
    options.exit = RefuseOptions(
        EditCommand(),
        "--size: expected WIDTHxHEIGHT from 320x240 to 16384x16384, not \"" + size + "\"");
  }
  return options;
}

}  // namespace coppice::editor
