#include "bt_core/live/discovery/robot_messages.h"

#include <arpa/nameser.h>
#include <strings.h>

#include <algorithm>
#include <climits>
#include <utility>

#include "bt_core/model/utf8.h"

namespace coppice {
namespace {

constexpr std::uint16_t kAnswer = 0x8400;   // flags: from who knows
constexpr std::uint16_t kOnlyOne = 0x8000;  // in a class: nobody else has this name
constexpr std::uint32_t kOfAnswer = 10;     // s that what was asked for holds, RFC 6762, 6.7
constexpr std::uint32_t kOfNames = 120;     // s that what was announced holds, RFC 6762, 10
constexpr int kMostQuestions = 16;          // that are looked at; records too
constexpr int kMostRecords = 64;
constexpr std::size_t kMostRobots = 8;

std::string InstanceOf(const RobotNotice& robot) { return robot.label + "." + kRobotService; }
std::string HostOf(const RobotNotice& robot) { return robot.label + ".local"; }

// Appends to a message. Names consist of labels that need no escaping.
class Writer {
 public:
  explicit Writer(std::string& bytes) : bytes_(bytes) {}

  void Number16(std::uint16_t number) {
    bytes_.push_back(static_cast<char>(number >> 8U));
    bytes_.push_back(static_cast<char>(number & 0xFFU));
  }
  void Number32(std::uint32_t number) {
    Number16(static_cast<std::uint16_t>(number >> 16U));
    Number16(static_cast<std::uint16_t>(number & 0xFFFFU));
  }
  // At most 255 bytes.
  void Text(std::string_view text) {
    bytes_.push_back(static_cast<char>(text.size()));
    bytes_ += text;
  }
  void Name(std::string_view name) {
    while (!name.empty()) {
      const std::size_t end = std::min(name.find('.'), name.size());
      Text(name.substr(0, end));
      name.remove_prefix(std::min(end + 1, name.size()));
    }
    bytes_.push_back(0);
  }
  void Head(std::uint16_t id, std::uint16_t flags, std::uint16_t questions, std::uint16_t answers) {
    for (const std::uint16_t number : {id, flags, questions, answers}) Number16(number);
    Number32(0);  // no other sections
  }
  void Record(const std::string& name, ns_type type, std::uint16_t in_class, std::uint32_t seconds,
              const std::string& data) {
    Name(name);
    Number16(static_cast<std::uint16_t>(type));
    Number16(in_class);
    Number32(seconds);
    Number16(static_cast<std::uint16_t>(data.size()));
    bytes_ += data;
  }

 private:
  std::string& bytes_;
};

std::string NameData(const std::string& name) {
  std::string data;
  Writer(data).Name(name);
  return data;
}

std::string PlaceData(const RobotNotice& robot) {
  std::string data;
  Writer writer(data);
  writer.Number32(0);  // priority and weight
  writer.Number16(robot.port);
  writer.Name(HostOf(robot));
  return data;
}

std::string TextData(const RobotNotice& robot) {
  std::string data;
  Writer writer(data);
  writer.Text("txtvers=1");
  writer.Text("host=" + PlainText(robot.host, kLongestNoticeText));
  writer.Text("tree=" + PlainText(robot.tree, kLongestNoticeText));
  if (robot.needs_token) writer.Text("token=1");
  return data;
}

// Four records. Who asks from a port of his own does not know what kOnlyOne means.
void WriteRecords(Writer& writer, const RobotNotice& robot, const Ipv4& address,
                  std::uint32_t seconds, bool is_asked) {
  const auto own = static_cast<std::uint16_t>(is_asked ? ns_c_in : ns_c_in | kOnlyOne);
  const std::string instance = InstanceOf(robot);
  writer.Record(kRobotService, ns_t_ptr, ns_c_in, seconds, NameData(instance));
  writer.Record(instance, ns_t_srv, own, seconds, PlaceData(robot));
  writer.Record(instance, ns_t_txt, own, seconds, TextData(robot));
  writer.Record(HostOf(robot), ns_t_a, own, seconds, std::string(address.begin(), address.end()));
}
constexpr std::uint16_t kRecords = 4;

// A message whose sections the resolver has found; any bytes may be handed in.
class Message {
 public:
  explicit Message(std::string_view bytes) : bytes_(bytes) {
    is_good_ = bytes.size() <= INT_MAX &&
               ns_initparse(Begin(), static_cast<int>(bytes.size()), &message_) == 0;
  }

  bool is_good() const { return is_good_; }
  std::uint16_t id() const { return ns_msg_id(message_); }
  bool is_answer() { return ns_msg_getflag(message_, ns_f_qr) != 0; }

  // Calls it with each record of the section, at most so many.
  template <class Do>
  void ForEach(ns_sect section, int most, const Do& run) {
    const int count = std::min<int>(ns_msg_count(message_, section), most);
    ns_rr record;
    for (int i = 0; i < count && ns_parserr(&message_, section, i, &record) == 0; ++i) run(record);
  }

  // A name within the data of a record, behind so many bytes; empty if there is none.
  std::string NameIn(const ns_rr& record, std::size_t at) const {
    char name[NS_MAXDNAME];
    if (at >= ns_rr_rdlen(record)) return {};
    const int read = ns_name_uncompress(Begin(), Begin() + bytes_.size(), ns_rr_rdata(record) + at,
                                        name, sizeof(name));
    return read < 0 ? "" : name;
  }

  // Its bytes, if it is the only one: a message may hold hundreds.
  std::string OnlyQuestion() const {
    const unsigned char* end = Begin() + NS_HFIXEDSZ;
    if (ns_msg_count(message_, ns_s_qd) != 1) return {};
    if (ns_name_skip(&end, Begin() + bytes_.size()) != 0) return {};
    return {Begin() + NS_HFIXEDSZ, end + NS_QFIXEDSZ};
  }

 private:
  const unsigned char* Begin() const {
    return reinterpret_cast<const unsigned char*>(bytes_.data());
  }

  const std::string_view bytes_;
  ns_msg message_{};
  bool is_good_ = false;
};

bool IsName(const char* name, std::string_view wanted) {
  return strcasecmp(name, std::string(wanted).c_str()) == 0;
}

bool IsAbout(const ns_rr& question, const RobotNotice& robot) {
  const auto is_type = [&](ns_type type) {
    return ns_rr_type(question) == type || ns_rr_type(question) == ns_t_any;
  };
  const char* const name = ns_rr_name(question);
  if (IsName(name, kRobotService)) return is_type(ns_t_ptr);
  if (IsName(name, InstanceOf(robot))) return is_type(ns_t_srv) || is_type(ns_t_txt);
  return IsName(name, HostOf(robot)) && is_type(ns_t_a);
}

// "label._coppice._tcp.local" without what follows the label; empty if it is something else.
std::string LabelOf(std::string_view name) {
  const std::string end = std::string(".") + kRobotService;
  if (name.size() <= end.size()) return {};
  const std::size_t at = name.size() - end.size();
  return IsName(std::string(name.substr(at)).c_str(), end) ? std::string(name.substr(0, at)) : "";
}

void ReadText(const ns_rr& record, RobotNotice& robot) {
  std::string_view data(reinterpret_cast<const char*>(ns_rr_rdata(record)), ns_rr_rdlen(record));
  while (!data.empty()) {
    const std::size_t size = static_cast<unsigned char>(data[0]);
    std::string_view text = data.substr(1, size);
    data.remove_prefix(std::min(size + 1, data.size()));
    const auto take = [&text](std::string_view key) {
      const bool is_it = text.substr(0, key.size()) == key;
      if (is_it) text.remove_prefix(key.size());
      return is_it;
    };
    if (take("host=")) robot.host = PlainText(text, kLongestNoticeText);
    if (take("tree=")) robot.tree = PlainText(text, kLongestNoticeText);
    if (take("token=")) robot.needs_token = text == "1";
  }
}

// Those of the records so far.
class Found {
 public:
  void Take(const ns_rr& record) {
    const std::string label = LabelOf(ns_rr_name(record));
    if (label.empty()) return;
    if (ns_rr_type(record) == ns_t_srv && ns_rr_rdlen(record) >= 7) {
      if (RobotNotice* const robot = Get(label)) robot->port = ns_get16(ns_rr_rdata(record) + 4);
    }
    if (ns_rr_type(record) == ns_t_txt) {
      if (RobotNotice* const robot = Get(label)) ReadText(record, *robot);
    }
  }

  // Without a port it cannot be reached.
  std::vector<RobotNotice> TakeAll() {
    robots_.erase(std::remove_if(robots_.begin(), robots_.end(),
                                 [](const RobotNotice& robot) { return robot.port == 0; }),
                  robots_.end());
    return std::move(robots_);
  }

 private:
  RobotNotice* Get(const std::string& label) {
    for (RobotNotice& robot : robots_) {
      if (robot.label == label) return &robot;
    }
    if (robots_.size() == kMostRobots) return nullptr;
    robots_.push_back({label, 0, "", "", false});
    return &robots_.back();
  }

  std::vector<RobotNotice> robots_;
};

}  // namespace

std::string QuestionMessage(std::uint16_t id) {
  std::string message;
  Writer writer(message);
  writer.Head(id, 0, 1, 0);
  writer.Name(kRobotService);
  writer.Number16(ns_t_ptr);
  writer.Number16(ns_c_in);
  return message;
}

std::optional<RobotQuestion> ReadQuestion(std::string_view bytes, const RobotNotice& robot) {
  Message message(bytes);
  if (!message.is_good() || message.is_answer()) return std::nullopt;
  bool is_asked = false;
  message.ForEach(ns_s_qd, kMostQuestions,
                  [&](const ns_rr& question) { is_asked |= IsAbout(question, robot); });
  message.ForEach(ns_s_an, kMostRecords, [&](const ns_rr& known) {
    if (ns_rr_type(known) != ns_t_ptr || ns_rr_ttl(known) < kOfNames / 2) return;
    if (IsName(message.NameIn(known, 0).c_str(), InstanceOf(robot))) is_asked = false;
  });
  if (!is_asked) return std::nullopt;
  return RobotQuestion{message.id(), message.OnlyQuestion()};
}

std::string AnswerMessage(const RobotNotice& robot, const Ipv4& address,
                          const RobotQuestion& question) {
  std::string message;
  Writer writer(message);
  writer.Head(question.id, kAnswer, question.bytes.empty() ? 0 : 1, kRecords);
  message += question.bytes;
  WriteRecords(writer, robot, address, kOfAnswer, true);
  return message;
}

std::string AnnouncementMessage(const RobotNotice& robot, const Ipv4& address, bool goes) {
  std::string message;
  Writer writer(message);
  writer.Head(0, kAnswer, 0, kRecords);
  WriteRecords(writer, robot, address, goes ? 0 : kOfNames, false);
  return message;
}

std::vector<RobotNotice> ReadAnswer(std::string_view bytes, std::uint16_t id) {
  Message message(bytes);
  if (!message.is_good() || !message.is_answer() || message.id() != id) return {};
  Found found;
  const auto take = [&found](const ns_rr& record) { found.Take(record); };
  message.ForEach(ns_s_an, kMostRecords, take);
  message.ForEach(ns_s_ar, kMostRecords, take);
  return found.TakeAll();
}

}  // namespace coppice
