// coppice-questionnaire: asks people what they think of the robot, and says what they answered.
#include <csignal>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "bt_core/base/command_line.h"
#include "robot_app/common/shipped.h"
#include "robot_app/common/web/call_server.h"
#include "robot_app/questionnaire/answers_file.h"
#include "robot_app/questionnaire/figures.h"
#include "robot_app/questionnaire/questionnaire.h"

namespace coppice::robot::questionnaire {
namespace {

const Command& QuestionnaireCommand() {
  static const Command command{
      "coppice-questionnaire",
      "ask people what they think of the robot",
      {"ANSWERS.csv", 1, 1},
      "Serves a page with the questions until it is stopped, and adds each person's marks to the\n"
      "file. With --figures it says instead what they are: medians, and Cronbach's alpha of each\n"
      "scale, beside those of the paper.",
      {CommandOption::Flag("--figures", "says what the answers are"),
       CommandOption::Text("--questions", "FILE", "else the Godspeed questionnaire"),
       CommandOption::Text("--address", "ADDRESS", "to listen on; else 127.0.0.1"),
       CommandOption::Whole("--port", "N", 0, 65535, "of the page, 0 = a free one; else 8092"),
       CommandOption::Text("--name", "NAME",
                           "by which browsers ask for it, if a name server knows it")}};
  return command;
}

int Fail(const std::string& problem) {
  std::cerr << "coppice-questionnaire: " << problem << "\n";
  return 1;
}

int ShowFigures(const Questionnaire& questionnaire, const std::string& file) {
  Diagnostics diagnostics;
  const std::vector<Marks> people = ReadAnswers(file, questionnaire, diagnostics);
  std::cerr << diagnostics.ToString();
  if (diagnostics.has_errors()) return 1;
  std::cout << FiguresText(questionnaire, people);
  return FinishOutput(0);
}

// The page asks for the questions with an empty text, and sends the marks.
std::string Reply(const Questionnaire& questionnaire, const std::string& file,
                  const std::string& call) {
  if (call.empty()) return questionnaire.ToJson();
  const Expected<Marks> marks = MarksOf(call, questionnaire);
  if (!marks) return R"({"error": "not understood"})";
  const Outcome added = AddAnswers(file, questionnaire, *marks);
  if (added) return "{}";
  std::cerr << added.problem();
  return R"({"error": "not written"})";
}

int Serve(const Questionnaire& questionnaire, const Options& options) {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  sigprocmask(SIG_BLOCK, &signals, nullptr);
  try {
    const std::string address = options.Get("--address", "127.0.0.1");
    const CallServer server(
        {address, static_cast<std::uint16_t>(options.Whole("--port", 8092)),
         Shipped(COPPICE_PAGE_FOLDER), options.Get("--name")},
        [&](const std::string& call) { return Reply(questionnaire, options.files[0], call); });
    std::cout << "http://" << address << ":" << server.port() << std::endl;
    int signal = 0;
    sigwait(&signals, &signal);
  } catch (const std::runtime_error& error) {
    return Fail(error.what());
  }
  return 0;
}

int Main(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions(QuestionnaireCommand(), arguments);
  if (options.exit) return *options.exit;
  Diagnostics diagnostics;
  const Questionnaire questionnaire =
      Questionnaire::Load(options.Get("--questions", Shipped(COPPICE_GODSPEED)), diagnostics);
  std::cerr << diagnostics.ToString();
  if (diagnostics.has_errors()) return 1;
  return options.Has("--figures") ? ShowFigures(questionnaire, options.files[0])
                                  : Serve(questionnaire, options);
}

}  // namespace
}  // namespace coppice::robot::questionnaire

int main(int argc, char** argv) {
  return coppice::robot::questionnaire::Main({argv + 1, argv + argc});
}
