#include "robot_app/assistance/assistance_config.h"

#include <algorithm>
#include <set>

#include "robot_app/common/yaml_fields.h"

namespace coppice::robot::assistance {
namespace {

using Kind = ChannelConfig::Kind;

const std::map<std::string, Kind> kKinds = {{"console", Kind::kConsole},
                                            {"smtp", Kind::kSmtp},
                                            {"telegram", Kind::kTelegram},
                                            {"matrix", Kind::kMatrix},
                                            {"webhook", Kind::kWebhook}};

std::vector<std::string> KindNames() {
  std::vector<std::string> names;
  for (const auto& [name, kind] : kKinds) names.push_back(name);
  return names;
}

bool BeginsWith(const std::string& text, const std::string& prefix) {
  return text.compare(0, prefix.size(), prefix) == 0;
}

bool IsOnThisComputer(const std::string& url) {
  const std::string host = url.substr(url.find("://") + 3);
  return BeginsWith(host, "127.") || BeginsWith(host, "localhost") || BeginsWith(host, "[::1]");
}

class Loader {
 public:
  Loader(const std::string& path, const Environment& environment, Diagnostics& diagnostics)
      : diagnostics_(diagnostics),
        environment_(environment),
        file_(YamlFields::Load(path, diagnostics)),
        readable_(!diagnostics.has_errors()) {}

  AssistanceConfig Load() {
    if (!readable_) return {};
    config_.robot = Optional(file_, "robot", "The robot");
    for (YamlFields& fields : file_.Maps("channels")) ReadChannel(fields);
    for (YamlFields& fields : file_.Maps("supervisors")) ReadSupervisor(fields);
    YamlFields rules = file_.Map("patience");
    config_.rules = ReadRules(rules, HelpRules{});
    rules.Finish();
    for (auto& [subject, node] : file_.Pairs("subjects")) {
      YamlFields fields = file_.MapOf(node);
      config_.rules_of_subject[subject.text] = ReadRules(fields, config_.rules);
      fields.Finish();
    }
    YamlFields page = file_.Map("page");
    ReadPage(page);
    file_.Finish();
    return std::move(config_);
  }

 private:
  // With its variables filled in; nothing, with a warning, if one has no value.
  std::optional<std::string> Filled(const LocatedText& text) {
    const Expected<std::string> filled = FillVariables(text.text, environment_);
    if (filled) return *filled;
    diagnostics_.Warning(text.where, filled.problem() + "; what needs it is left out");
    return std::nullopt;
  }

  std::string Optional(YamlFields& fields, const std::string& key, const std::string& otherwise) {
    return Filled(fields.Text(key, otherwise)).value_or("");
  }

  std::optional<std::string> Required(YamlFields& fields, const std::string& key) {
    return Filled(fields.Text(key));
  }

  // Must be nothing but a variable.
  std::optional<std::string> Secret(YamlFields& fields, const std::string& key) {
    const LocatedText text = fields.Text(key, "");
    if (text.text.empty()) return "";
    if (!IsVariable(text.text)) {
      fields.Error(text.where, "\"" + key + "\": a secret must not stand in a file",
                   "write \"${COPPICE_...}\" and set that variable where the program runs");
      return "";
    }
    return Filled(text);
  }

  // Of those that can be used again and again, and so be guessed again and again.
  std::string PageToken(YamlFields& fields, const std::string& key) {
    std::string token = Secret(fields, key).value_or("");
    if (token.empty() || token.size() >= PageConfig::kLeastTokenLength) return token;
    fields.Error(fields.Text(key, "").where,
                 "\"" + key + "\": the token has " + std::to_string(token.size()) +
                     " characters, at least " + std::to_string(PageConfig::kLeastTokenLength) +
                     " are needed",
                 "make one with openssl rand -hex 24");
    return "";
  }

  void ReadChannel(YamlFields& fields) {
    ChannelConfig channel;
    const SourceLocation where = fields.where();
    channel.name = fields.Text("name").text;
    channel.kind = kKinds.at(fields.Choice("kind", "console", KindNames()));
    if (!names_of_channels_.insert(channel.name).second) {
      fields.Error(where, "channel \"" + channel.name + "\" is listed twice");
    }
    if (ReadAccess(fields, channel)) {
      CheckUrl(fields, channel, where);
      config_.channels.push_back(channel);
    }
    fields.Finish();
  }

  // False if something is not set in the environment.
  bool ReadAccess(YamlFields& fields, ChannelConfig& channel) {
    if (channel.kind == Kind::kConsole) return true;
    if (channel.kind == Kind::kTelegram) {
      channel.answers = fields.Choice("answers", "yes", {"yes", "no"}) == "yes";
    }
    const bool is_smtp = channel.kind == Kind::kSmtp;
    const std::optional<std::string> url =
        channel.kind == Kind::kTelegram ? Filled(fields.Text("url", "https://api.telegram.org"))
                                        : Required(fields, "url");
    const std::optional<std::string> secret = Secret(fields, is_smtp ? "password" : "token");
    const std::optional<std::string> user = is_smtp ? Filled(fields.Text("user", "")) : "";
    const std::optional<std::string> from = is_smtp ? Required(fields, "from") : "";
    if (!url || !secret || !user || !from) return false;
    channel.url = *url;
    channel.secret = *secret;
    channel.user = *user;
    channel.from = *from;
    return true;
  }

  static void CheckUrl(const YamlFields& fields, const ChannelConfig& channel,
                       const SourceLocation& where) {
    const bool is_smtp = channel.kind == Kind::kSmtp;
    const std::string scheme = is_smtp ? "smtp" : "http";
    if (channel.kind == Kind::kConsole || channel.url.empty()) return;
    if (!BeginsWith(channel.url, scheme + "://") && !BeginsWith(channel.url, scheme + "s://")) {
      fields.Error(where, "\"url\" must begin with " + scheme + "s:// or " + scheme + "://");
    } else if (!is_smtp && !channel.secret.empty() && BeginsWith(channel.url, "http://") &&
               !IsOnThisComputer(channel.url)) {
      fields.Error(where, "a token must not go over http://", "use https://");
    }
    if (channel.secret.empty() &&
        (channel.kind == Kind::kTelegram || channel.kind == Kind::kMatrix)) {
      fields.Error(where, "\"token\" is missing");
    }
  }

  void ReadSupervisor(YamlFields& fields) {
    HumanSupervisor supervisor;
    const LocatedText name = fields.Text("name");
    supervisor.name = name.text;
    if (!names_of_supervisors_.insert(name.text).second) {
      fields.Error(name.where, "supervisor \"" + name.text + "\" is listed twice");
    }
    for (YamlFields& way : fields.Maps("reach")) ReadWay(way, supervisor);
    fields.Finish();
    if (!supervisor.ways.empty()) {
      config_.supervisors.push_back(std::move(supervisor));
    } else if (!fields.Has("reach")) {
      fields.Error(fields.where(), "\"reach\" names no channel");
    }
  }

  void ReadWay(YamlFields& fields, HumanSupervisor& supervisor) {
    const LocatedText channel = fields.Text("channel");
    const LocatedText to = fields.Text("to", "");
    fields.Finish();
    if (names_of_channels_.count(channel.text) == 0) {
      fields.Error(
          channel.where, "unknown channel \"" + channel.text + "\"",
          DidYouMean(channel.text, {names_of_channels_.begin(), names_of_channels_.end()}));
      return;
    }
    const auto found = std::find_if(
        config_.channels.begin(), config_.channels.end(),
        [&](const ChannelConfig& candidate) { return candidate.name == channel.text; });
    if (found == config_.channels.end()) return;  // left out
    const bool needs_address = found->kind != Kind::kConsole && found->kind != Kind::kWebhook;
    if (needs_address && to.text.empty()) fields.Error(channel.where, "\"to\" is missing");
    if (const std::optional<std::string> address = Filled(to)) {
      supervisor.ways.push_back({channel.text, *address});
    }
  }

  static HelpRules ReadRules(YamlFields& fields, const HelpRules& otherwise) {
    const auto seconds = [&](const char* key, Duration value, double low) {
      const double number = std::chrono::duration<double>(value).count();
      return fields.Seconds(key, number, low, 7 * 86400.0);
    };
    HelpRules rules;
    rules.remind = seconds("remind", otherwise.remind, 1);
    rules.next = seconds("next", otherwise.next, 1);
    rules.deadline = seconds("deadline", otherwise.deadline, 1);
    rules.settle = seconds("settle", otherwise.settle, 0);
    const char* const default_answer = otherwise.ok_when_nobody ? "fixed" : "not_fixed";
    rules.ok_when_nobody =
        fields.Choice("when_nobody", default_answer, {"fixed", "not_fixed"}) == "fixed";
    rules.when_nobody = fields.Text("then", otherwise.when_nobody).text;
    return rules;
  }

  void ReadPage(YamlFields& fields) {
    PageConfig& page = config_.page;
    page.address = Optional(fields, "address", page.address);
    page.port = static_cast<std::uint16_t>(fields.Integer("port", page.port, 0, 65535));
    page.public_url = Optional(fields, "public_url", "");
    while (!page.public_url.empty() && page.public_url.back() == '/') page.public_url.pop_back();
    page.editor_url = Optional(fields, "editor_url", "");
    if (!page.editor_url.empty() && !BeginsWith(page.editor_url, "http")) {
      fields.Error(fields.where(), "\"editor_url\" must begin with https:// or http://");
    }
    page.operator_token = PageToken(fields, "operator_token");
    page.viewer_token = PageToken(fields, "viewer_token");
    page.most_linear = fields.Number("most_linear", page.most_linear, 0.01, 2);
    page.most_angular = fields.Number("most_angular", page.most_angular, 0.01, 3);
    page.stop_distance = fields.Number("stop_distance", page.stop_distance, 0.05, 5);
    for (YamlFields& camera : fields.Maps("cameras")) {
      page.cameras.push_back({camera.Text("name").text, camera.Text("topic").text});
      camera.Finish();
    }
    fields.Finish();
  }

  Diagnostics& diagnostics_;
  const Environment& environment_;
  YamlFields file_;
  const bool readable_;
  AssistanceConfig config_;
  std::set<std::string> names_of_channels_;
  std::set<std::string> names_of_supervisors_;
};

}  // namespace

const HelpRules& AssistanceConfig::RulesOf(const std::string& subject) const {
  const auto found = rules_of_subject.find(subject);
  return found == rules_of_subject.end() ? rules : found->second;
}

AssistanceConfig LoadAssistanceConfig(const std::string& path, const Environment& environment,
                                      Diagnostics& diagnostics) {
  return Loader(path, environment, diagnostics).Load();
}

}  // namespace coppice::robot::assistance
