// coppice-face: shows what expressions look like, in the terminal or as a picture.
#include <chrono>
#include <iostream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "bt_core/base/command_line.h"
#include "bt_core/model/write_file.h"
#include "robot_app/common/shipped.h"
#include "robot_app/expression/expression_table.h"
#include "robot_app/expression/face_painter.h"
#include "robot_app/expression/face_texts.h"

namespace coppice::robot::expression {
namespace {

constexpr double kPeriod = 0.05;  // s

const Command& FaceCommand() {
  static const Command command{
      "coppice-face",
      "show how the robot looks",
      {"[EXPRESSION]", 0, 1},
      "Plays an expression in the terminal, which must know 24-bit colours, or lists all of them.\n"
      "Checks the whole file first: all that is wrong in it is told, with file and line.",
      {CommandOption::Text("--file", "FILE", "the table of expressions; else the shipped one"),
       CommandOption::Real("--seconds", "S", 0, 86400, "how long; else 10"),
       CommandOption::Text("--picture", "FILE.png", "writes all expressions there instead")}};
  return command;
}

void Play(const Appearance& appearance, double seconds) {
  std::cout << "\x1b[2J\x1b[?25l";
  for (double now = 0; now < seconds; now += kPeriod) {
    const LimbAngles& limbs = LimbsAt(appearance, now);
    std::cout << "\x1b[H" << TerminalText(PaintFace(FaceAt(appearance, now))) << "ears " << limbs[0]
              << " " << limbs[1] << "  arms " << limbs[2] << " " << limbs[3] << " rad\x1b[K\n"
              << std::flush;
    std::this_thread::sleep_for(std::chrono::duration<double>(kPeriod));
  }
  std::cout << "\x1b[?25h";
}

int WritePicture(const ExpressionTable& table, const std::string& path) {
  const std::vector<std::uint8_t> png = EncodePng(Overview(table));
  Diagnostics diagnostics;
  const bool is_written =
      WriteFile(path, {reinterpret_cast<const char*>(png.data()), png.size()}, diagnostics);
  std::cerr << diagnostics.ToString();
  return is_written ? 0 : 1;
}

int ShowOne(const ExpressionTable& table, const std::string& name, double seconds) {
  Expression expression{};
  if (!ValueTraits<Expression>::Parse(name, expression)) {
    return RefuseOptions(FaceCommand(), "there is no expression \"" + name + "\"; expected " +
                                            Choices(EnumeratorsOf<Expression>()));
  }
  Play(table[expression], seconds);
  return FinishOutput(0);
}

int List() {
  for (const Enumerator& one : ValueTraits<Expression>::kEnumerators) std::cout << one.name << "\n";
  return FinishOutput(0);
}

int Main(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions(FaceCommand(), arguments);
  if (options.exit) return *options.exit;
  Diagnostics diagnostics;
  const ExpressionTable table =
      ReadExpressions(options.Get("--file", Shipped(COPPICE_EXPRESSIONS)), diagnostics);
  std::cerr << diagnostics.ToString();
  if (diagnostics.has_errors()) return 1;
  if (options.Has("--picture")) return WritePicture(table, options.Get("--picture"));
  return options.files.empty() ? List()
                               : ShowOne(table, options.files[0], options.Real("--seconds", 10));
}

}  // namespace
}  // namespace coppice::robot::expression

int main(int argc, char** argv) {
  return coppice::robot::expression::Main({argv + 1, argv + argc});
}
