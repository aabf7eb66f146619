#include "editor/app/edit_options.h"

#include <cstdio>
#include <cstdlib>

namespace coppice::editor {
namespace {

bool ReadSeconds(const std::string& text, double& seconds) {
  char* end = nullptr;
  seconds = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' && seconds > 0 && seconds < 1e9;
}

bool ReadSize(const std::string& text, int& width, int& height) {
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2) return false;
  return width >= 320 && height >= 240 && width <= 16384 && height <= 16384;
}

// Sets one option; false if the value is not what was expected.
bool Set(const std::string& name, const std::string& value, EditOptions& options,
         std::string& expected) {
  if (name == "--connect") {
    options.robots.push_back(value);
  } else if (name == "--models") {
    options.models.push_back(value);
  } else if (name == "--picture") {
    options.picture = value;
  } else if (name == "--every") {
    expected = "seconds";
    return ReadSeconds(value, options.picture_every);
  } else if (name == "--for") {
    expected = "seconds";
    return ReadSeconds(value, options.run_for);
  } else if (name == "--size") {
    expected = "WIDTHxHEIGHT from 320x240 to 16384x16384";
    return ReadSize(value, options.width, options.height);
  } else if (name == "--palette") {
    expected = "dark, light or colourblind";
    const std::optional<PaletteName> palette = PaletteFromString(value);
    if (palette) options.palette = *palette;
    return palette.has_value();
  }
  return true;
}

bool TakesValue(const std::string& name) {
  for (const char* known :
       {"--connect", "--models", "--picture", "--every", "--for", "--size", "--palette"}) {
    if (name == known) return true;
  }
  return false;
}

}  // namespace

const char* const kEditUsage =
    "coppice-edit [FILES...] [options]\n"
    "  Shows behaviour trees: of files (.xml), live of robots that speak the Groot2 protocol, and\n"
    "  of records of runs (.coppice, and .btlog of BehaviorTree.CPP).\n"
    "  --connect HOST:PORT  follow a robot; may be given several times\n"
    "  --models FILE        XML file with a <TreeNodesModel>; may be given several times\n"
    "  --palette NAME       dark, light or colourblind\n"
    "  --reduce-motion      nothing pulses, walks or glides\n"
    "  --size WxH           of the window (1280x800)\n"
    "  --picture FILE.png   save what the window shows, at the end\n"
    "  --every SECONDS      save the picture again and again\n"
    "  --headless           needs no display; use it with --picture\n"
    "  --for SECONDS        end after that time\n";

std::optional<EditOptions> ParseEditOptions(const std::vector<std::string>& arguments,
                                            std::string& error) {
  EditOptions options;
  error.clear();
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument == "--help" || argument == "-h") return std::nullopt;
    if (argument == "--headless") {
      options.headless = true;
    } else if (argument == "--reduce-motion") {
      options.reduce_motion = true;
    } else if (TakesValue(argument)) {
      if (i + 1 == arguments.size()) {
        error = argument + " needs a value";
        return std::nullopt;
      }
      std::string expected;
      if (!Set(argument, arguments[++i], options, expected)) {
        error = argument + " expects " + expected + ", not \"" + arguments[i] + "\"";
        return std::nullopt;
      }
    } else if (argument.size() > 1 && argument[0] == '-') {
      error = "unknown option " + argument;
      return std::nullopt;
    } else {
      options.files.push_back(argument);
    }
  }
  return options;
}

}  // namespace coppice::editor
