// Changes texts at random, the same way in every run.
#ifndef COPPICE_TESTS_FUZZ_MUTATOR_H_
#define COPPICE_TESTS_FUZZ_MUTATOR_H_

#include <random>
#include <string>
#include <vector>

namespace coppice::fuzz {

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string Mutate(std::string text) {
    for (int edits = Uniform(1, 4); edits > 0 && !text.empty(); --edits) Edit(text);
    return text;
  }

 private:
  std::size_t Uniform(std::size_t from, std::size_t to) {
    return std::uniform_int_distribution<std::size_t>(from, to)(random_);
  }

  void Edit(std::string& text) {
    static const std::vector<std::string> kTokens = {"<",
                                                     ">",
                                                     "/>",
                                                     "\"",
                                                     "'",
                                                     "=",
                                                     "&",
                                                     "&#x0;",
                                                     "&#1114112;",
                                                     "{",
                                                     "}",
                                                     "{=}",
                                                     "{@}",
                                                     "@",
                                                     "\r\n",
                                                     "\xEF\xBB\xBF",
                                                     "<!--",
                                                     "-->",
                                                     "<?",
                                                     "-1",
                                                     "1e999",
                                                     "nan",
                                                     "\xFF",
                                                     R"(ID="Main")",
                                                     R"(<SubTree ID="Main"/>)",
                                                     R"(<include path="."/>)",
                                                     "<![CDATA[",
                                                     "</Sequence>",
                                                     "4294967296",
                                                     "<root>",
                                                     R"(_autoremap="1")"};
    const std::size_t at = Uniform(0, text.size() - 1);
    switch (Uniform(0, 4)) {
      case 0:
        text[at] = static_cast<char>(Uniform(0, 255));
        break;
      case 1:
        text.erase(at, Uniform(1, 40));
        break;
      case 2:
        text.insert(at, kTokens[Uniform(0, kTokens.size() - 1)]);
        break;
      case 3: {  // repeat a piece elsewhere
        const std::string piece = text.substr(at, Uniform(1, 80));
        text.insert(Uniform(0, text.size()), piece);
        break;
      }
      default:
        text.resize(at);
    }
  }

  std::mt19937 random_;
};

}  // namespace coppice::fuzz

#endif  // COPPICE_TESTS_FUZZ_MUTATOR_H_
