#include <iostream>

#include "bt_core/cli/verbs.h"

namespace coppice {
namespace {

// Behind the tables: what bash calls.
constexpr char kBash[] = R"(
_coppice() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}
  local verb=${COMP_WORDS[1]} words
  if [ "$COMP_CWORD" -eq 1 ]; then
    words=$_coppice_verbs
  elif words=$(_coppice_choices "$verb $before"); [ -z "$words" ] && [[ $word == -* ]]; then
    words=$(_coppice_options "$verb")
    [ -n "$words" ] || words=$(coppice "$verb" --help 2>/dev/null | grep -o '^ *-[-a-z]*')
  fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -o default -F _coppice coppice
)";

void PrintCase(const std::string& pattern, const std::string& words) {
  std::cout << "    \"" << pattern << "\") echo \"" << words << "\" ;;\n";
}

void PrintBash() {
  std::cout << "# Completion for bash: eval \"$(coppice completion bash)\"\n_coppice_verbs=\"";
  for (const Verb& verb : Verbs()) std::cout << verb.name() << " ";
  std::cout << "\"\n_coppice_options() {\n  case \"$1\" in\n";
  for (const Verb& verb : Verbs()) {
    std::string words = "--help";
    for (const CommandOption& option : verb.command().options) words += " " + option.name;
    PrintCase(verb.name(), words);
  }
  std::cout << "  esac\n}\n_coppice_choices() {\n  case \"$1\" in\n";
  for (const Verb& verb : Verbs()) {
    for (const CommandOption& option : verb.command().options) {
      std::string words;
      for (const std::string& choice : option.choices) words += choice + " ";
      if (!words.empty()) PrintCase(verb.name() + " " + option.name, words);
    }
  }
  std::cout << "  esac\n}" << kBash;
}

}  // namespace

const Command& CompletionCommand() {
  static const Command command{
      "coppice completion",
      "make the shell complete verbs and options",
      {"bash", 1, 1},
      R"help(Prints what a shell needs; bash takes it from a line in ~/.bashrc:
  eval "$(coppice completion bash)")help",
      {}};
  return command;
}

int RunCompletion(const Arguments& arguments) {
  const Options options = ParseOptions(CompletionCommand(), arguments);
  if (options.exit) return *options.exit;
  if (options.files[0] != "bash") {
    return RefuseOptions(CompletionCommand(), "knows bash, not \"" + options.files[0] + "\"");
  }
  PrintBash();
  return 0;
}

}  // namespace coppice
