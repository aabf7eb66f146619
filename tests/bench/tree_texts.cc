#include "tests/bench/tree_texts.h"

#include <algorithm>

#include "bt_core/engine/compile/models.h"

namespace coppice::bench {
namespace {

class FullTreeWriter {
 public:
  explicit FullTreeWriter(int arity) : arity_(arity) {}

  void Write(int nodes, int depth, int indent) {
    if (nodes == 1) {
      Line(indent, leaves_++ % 2 == 0 ? "<CondOk/>" : "<ActOk/>");
      return;
    }
    static const char* const kKinds[] = {"Sequence", "Fallback", "ReactiveSequence"};
    std::string kind = kKinds[depth % 3];
    const int rest = nodes - 1;
    const int children = std::min(arity_, rest);
    const int inverters = children - 1;
    if (kind == "Fallback" && rest < children + inverters) kind = "Sequence";
    const bool wrap = kind == "Fallback";
    const int to_split = rest - (wrap ? inverters : 0);
    Line(indent, "<" + kind + ">");
    for (int i = 0; i < children; ++i) {
      const int share = to_split / children + (i < to_split % children ? 1 : 0);
      const bool wrapped = wrap && i < inverters;
      if (wrapped) Line(indent + 1, "<Inverter>");
      Write(share, depth + 1, indent + (wrapped ? 2 : 1));
      if (wrapped) Line(indent + 1, "</Inverter>");
    }
    Line(indent, "</" + kind + ">");
  }

  const std::string& text() const { return text_; }

 private:
  void Line(int indent, const std::string& line) {
    text_.append(static_cast<std::size_t>(indent) * 2, ' ').append(line).append("\n");
  }

  int arity_;
  int leaves_ = 0;
  std::string text_;
};

std::string Document(const std::string& body) {
  return "<root BTCPP_format=\"4\" main_tree_to_execute=\"Main\">\n<BehaviorTree ID=\"Main\">\n" +
         body + "</BehaviorTree>\n</root>\n";
}

template <class Monitor>
std::string Arbiter(Monitor monitor) {
  std::string body = "<ReactiveFallback>\n";
  for (int i = 0; i < 50; ++i) body += "  " + monitor(i) + "\n";
  return Document(body + "  <RunForever/>\n</ReactiveFallback>\n");
}

}  // namespace

std::string FullTree(int arity, int nodes) {
  FullTreeWriter writer(arity);
  writer.Write(nodes, 0, 0);
  return Document(writer.text());
}

std::string FlatArbiter() {
  return Arbiter([](int) { return std::string("<CondFail/>"); });
}

std::string GuardedArbiter() {
  return Arbiter([](int) { return std::string("<Sequence><CondFail/><ActOk/></Sequence>"); });
}

std::string PortArbiter() {
  return Arbiter(
      [](int) { return std::string(R"(<CondPort value="{battery}" threshold="20"/>)"); });
}

std::string ScriptArbiter() {
  return Arbiter([](int i) {
    return "<ScriptCondition" + Attribute("code", "battery < " + std::to_string(i)) + "/>";
  });
}

std::string SequenceOf(int count, const std::string& node) {
  std::string body = "<Sequence>\n";
  for (int i = 0; i < count; ++i) body += "  " + node + "\n";
  return Document(body + "</Sequence>\n");
}

std::string ArmedTimeouts(int count) {
  std::string body = "<Parallel success_count=\"-1\">\n";
  for (int i = 0; i < count; ++i) body += "  <Timeout msec=\"3600000\"><RunForever/></Timeout>\n";
  return Document(body + "</Parallel>\n");
}

std::string Attribute(const std::string& name, const std::string& script) {
  return " " + name + "=\"" + EscapeXml(script) + "\"";
}

}  // namespace coppice::bench
