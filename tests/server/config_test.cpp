#include "config/config.hpp"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "config/options.hpp"
#include "tuftwave/limits.hpp"

namespace tuftwave::server {
namespace {

using Command = CommandLine::Command;
using Words = std::vector<std::string>;
using Texts = std::map<std::string, std::string>;

std::variant<CommandLine, UsageError> parsed(const Words& words, const Texts& environment = {},
                                             const Texts& files = {}) {
    const auto look_up = [](const Texts& texts) {
        return [texts](const std::string& name) -> std::optional<std::string> {
            const auto found = texts.find(name);
            return found == texts.end() ? std::nullopt : std::optional(found->second);
        };
    };
    return parse(words, {look_up(environment), look_up(files)});
}

/// The message of a refusal, or what came instead.
std::string message(const Words& words, const Texts& environment = {}, const Texts& files = {}) {
    const auto result = parsed(words, environment, files);
    const auto* error = std::get_if<UsageError>(&result);
    return error ? error->message : "accepted";
}

Config config(const Words& words, const Texts& environment = {}, const Texts& files = {}) {
    const auto result = parsed(words, environment, files);
    if (const auto* error = std::get_if<UsageError>(&result)) ADD_FAILURE() << error->message;
    const auto* line = std::get_if<CommandLine>(&result);
    return line ? line->config : Config{};
}

Command command(const Words& words) {
    const auto result = parsed(words);
    const auto* line = std::get_if<CommandLine>(&result);
    EXPECT_TRUE(line);
    return line ? line->command : Command::kServe;
}

TEST(Config, FlagGoesBeforeEnvironmentBeforeFileBeforeDefault) {
    const Texts files{{"c.json", R"({"port": 3})"}};
    EXPECT_EQ(config({}).port, 8080);
    EXPECT_EQ(config({"--config", "c.json"}, {}, files).port, 3);
    EXPECT_EQ(config({}, {{"TUFTWAVE_CONFIG", "c.json"}}, files).port, 3);
    EXPECT_EQ(config({"--config", "c.json"}, {{"PORT", "2"}}, files).port, 2);
    EXPECT_EQ(config({"--config", "c.json"}, {{"PORT", "2"}, {"TUFTWAVE_PORT", "22"}}, files).port, 22);
    EXPECT_EQ(config({"--config", "c.json", "--port", "1"}, {{"TUFTWAVE_PORT", "22"}}, files).port, 1);
    EXPECT_EQ(config({"--config", "c.json"}, {{"TUFTWAVE_CONFIG", "other.json"}}, files).port, 3);
}

TEST(Config, PlainPortIsOnlyForThePublicListener) {
    EXPECT_EQ(config({}, {{"PORT", "2"}}).admin_port, 8081);
    EXPECT_EQ(config({}, {{"TUFTWAVE_ADMIN_PORT", "2"}}).admin_port, 2);
}

TEST(Config, EmptyVariableCountsAsNone) {
    EXPECT_EQ(config({}, {{"TUFTWAVE_PORT", ""}, {"PORT", "2"}, {"TUFTWAVE_CONFIG", ""}}).port, 2);
}

TEST(Config, FlagTakesItsValueAfterAnEqualsSignOrASpace) {
    EXPECT_EQ(config({"--port=1", "--host", "::1"}).port, 1);
    EXPECT_EQ(config({"--port=1", "--host", "::1"}).host, "::1");
    EXPECT_EQ(config({"--port=1", "--port", "2"}).port, 2) << "the later one";
}

TEST(Config, CommandsAreRecognised) {
    EXPECT_EQ(command({}), Command::kServe);
    EXPECT_EQ(command({"--help"}), Command::kHelp);
    EXPECT_EQ(command({"-h"}), Command::kHelp);
    EXPECT_EQ(command({"--version"}), Command::kVersion);
    EXPECT_EQ(command({"--print-config", "--port", "1"}), Command::kPrintConfig);
    EXPECT_EQ(command({"healthcheck", "--admin-port=1"}), Command::kHealthcheck);
    EXPECT_EQ(command({"--port", "1", "--help", "--no-such-flag"}), Command::kHelp) << "whatever stands behind it";
}

TEST(Config, EveryRangeHasItsEndsInsideAndTheNextValuesOutside) {
    for (const Option& option : options()) {
        if (std::holds_alternative<std::string Config::*>(option.field)) continue;
        const double step = std::holds_alternative<int Config::*>(option.field) ? 1 : 0.01;
        const std::string flag = "--" + std::string(option.name) + "=";
        for (const double inside : {option.minimum, option.maximum})
            EXPECT_EQ(value_text(option, config({flag + to_text(inside)})), to_text(inside)) << flag;
        for (const double outside : {option.minimum - step, option.maximum + step})
            EXPECT_NE(message({flag + to_text(outside)}), "accepted") << flag << to_text(outside);
    }
}

TEST(Config, EveryChoiceIsAcceptedAndAnotherWordIsNot) {
    for (const char* level : {"debug", "info", "warn", "error", "off"})
        EXPECT_EQ(config({"--log-level", level}).log_level, level);
    for (const char* format : {"auto", "json", "text"}) EXPECT_EQ(config({"--log-format", format}).log_format, format);
    EXPECT_NE(message({"--log-level", "loud"}), "accepted");
    EXPECT_NE(message({"--log-format", "json|text"}), "accepted");
}

struct BadValue {
    Words words;
    Texts environment;
    std::string file;
    std::string message;
};

TEST(Config, BadValueIsNamedWithItsOriginAndWhatIsAllowed) {
    const std::string port = " is not a whole number from 0 to 65535";
    const std::vector<BadValue> table{
        {{"--port", "70000"}, {}, "", "option port: \"70000\" from the flag --port" + port},
        {{"--port=-1"}, {}, "", "option port: \"-1\" from the flag --port" + port},
        {{"--port=8080x"}, {}, "", "option port: \"8080x\" from the flag --port" + port},
        {{"--port=1.5"}, {}, "", "option port: \"1.5\" from the flag --port" + port},
        {{"--port="}, {}, "", "option port: \"\" from the flag --port" + port},
        {{"--port=99999999999"}, {}, "", "option port: \"99999999999\" from the flag --port" + port},
        {{"--host="}, {}, "", "option host: \"\" from the flag --host is not a text of 1 to 255 characters"},
        {{"--deadline", "nan"},
         {},
         "",
         "option deadline: \"nan\" from the flag --deadline is not a number from 0.1 to 600"},
        {{}, {{"PORT", "http"}}, "", "option port: \"http\" from the environment variable PORT" + port},
        {{},
         {{"TUFTWAVE_LOG_LEVEL", "loud"}},
         "",
         "option log-level: \"loud\" from the environment variable TUFTWAVE_LOG_LEVEL is not one of "
         "debug|info|warn|error|off"},
        {{}, {}, R"({"port": 70000})", "option port: \"70000\" from the file \"c.json\"" + port},
        {{}, {}, R"({"port": "80"})", "option port: \"80\" from the file \"c.json\"" + port},
        {{}, {}, R"({"port": 80.5})", "option port: \"80.5\" from the file \"c.json\"" + port},
        {{}, {}, R"({"port": null})", "option port: null from the file \"c.json\"" + port},
        {{}, {}, R"({"port": [80]})", "option port: a list or an object from the file \"c.json\"" + port},
        {{}, {}, R"({"host": 1})", "option host: 1 from the file \"c.json\" is not a text of 1 to 255 characters"},
        {{},
         {},
         R"({"admin_port": 80})",
         "unknown key \"admin_port\" in the file \"c.json\"; did you mean admin-port?"},
        {{}, {}, R"({"config": "d"})", "unknown key \"config\" in the file \"c.json\"; --help lists what there is"},
        {{}, {}, "[]", "the file \"c.json\" is not a JSON object"},
        {{}, {}, "{", "the file \"c.json\" is not a JSON object"},
        {{"--config", "none.json"}, {}, "", "the file \"none.json\" cannot be read"},
        {{"--prot", "1"}, {}, "", "unknown argument \"--prot\"; did you mean --port?"},
        {{"--prot=1"}, {}, "", "unknown argument \"--prot\"; did you mean --port?"},
        {{"serve"}, {}, "", "unknown argument \"serve\"; --help lists what there is"},
        {{"--port"}, {}, "", "the flag --port needs a value"},
    };
    for (const BadValue& row : table) {
        Texts environment = row.environment;
        if (!row.file.empty()) environment["TUFTWAVE_CONFIG"] = "c.json";
        EXPECT_EQ(message(row.words, environment, {{"c.json", row.file}}), row.message);
    }
}

TEST(Config, HelpListsEveryOptionWithItsDefaultRangeAndVariables) {
    const std::string text = help();
    for (const Option& option : options()) {
        const std::size_t flag = text.find("--" + std::string(option.name) + " VALUE\n");
        ASSERT_NE(flag, std::string::npos) << option.name;
        const std::string entry = text.substr(flag, text.find("  --", flag + 1) - flag);
        const std::string standard = value_text(option, Config{});
        EXPECT_NE(entry.find("Default " + (standard.empty() ? "none" : standard) + ";"), std::string::npos) << entry;
        EXPECT_NE(entry.find(allowed(option)), std::string::npos) << entry;
        for (const std::string& name : environment_names(option))
            EXPECT_NE(entry.find(name), std::string::npos) << entry;
    }
    EXPECT_NE(text.find("--config FILE"), std::string::npos);
    EXPECT_NE(text.find("healthcheck"), std::string::npos);
}

TEST(Config, DefaultsAreAllowedThemselves) {
    for (const Option& option : options()) {
        Config same;
        EXPECT_TRUE(set(option, value_text(option, Config{}), same)) << option.name;
    }
}

TEST(Config, PrintedConfigurationCanBeFedBack) {
    const Words words{"--host=::1",
                      "--port=1",
                      "--admin-host=localhost",
                      "--admin-port=2",
                      "--workers=3",
                      "--queue=4",
                      "--connections=9",
                      "--deadline=0.3",
                      "--queue-wait=0.2",
                      "--body-memory=5",
                      "--answer-memory=6",
                      "--drain=1.5",
                      "--log-level=warn",
                      "--log-format=text",
                      "--key-file=k",
                      "--insecure=yes",
                      "--origins=https://a.example",
                      "--rate=5.5",
                      "--burst=6.5"};
    ASSERT_EQ(words.size(), options().size()) << "an option is missing here";
    const std::string printed = to_json(config(words));
    EXPECT_EQ(to_json(config({"--config=c.json"}, {}, {{"c.json", printed}})), printed);
    EXPECT_NE(printed, to_json(Config{}));
    const nlohmann::json json = nlohmann::json::parse(printed, nullptr, false);
    for (const Option& option : options()) EXPECT_TRUE(json.contains(option.name)) << option.name;
}

TEST(Config, OnlyTheMachineItselfIsLoopback) {
    for (const char* host : {"127.0.0.1", "127.255.0.9", "::1", "localhost"}) EXPECT_TRUE(is_loopback(host)) << host;
    for (const char* host : {"0.0.0.0", "::", "128.0.0.1", "126.255.255.255", "10.0.0.1", "127.example",
                             "127.0.0.1.example", "localhost.example", "127.1", "::ffff:10.0.0.1", "", " 127.0.0.1"})
        EXPECT_FALSE(is_loopback(host)) << host;
}

TEST(Config, AnAddressForStrangersNeedsKeysOrAnExplicitWord) {
    const std::string refusal =
        "the host \"0.0.0.0\" can be reached from elsewhere: give the keys that may call with --key-file PATH, or "
        "serve "
        "everybody with --insecure yes";
    EXPECT_EQ(message({"--host=0.0.0.0"}), refusal);
    EXPECT_EQ(message({}, {{"TUFTWAVE_HOST", "0.0.0.0"}}), refusal);
    EXPECT_EQ(message({"--host=0.0.0.0", "--insecure=no"}), refusal);
    EXPECT_EQ(message({"--host=0.0.0.0"}, {{"TUFTWAVE_KEY_FILE", ""}}), refusal);
    EXPECT_EQ(message({"--host=0.0.0.0", "--insecure=yes"}), "accepted");
    EXPECT_EQ(message({"--host=0.0.0.0"}, {{"TUFTWAVE_INSECURE", "yes"}}), "accepted");
    EXPECT_EQ(message({"--host=0.0.0.0", "--key-file=keys"}), "accepted");
    EXPECT_EQ(message({"--admin-host=0.0.0.0"}), "accepted");
    EXPECT_EQ(message({"healthcheck", "--host=0.0.0.0"}), "accepted") << "it only looks at what runs";
    EXPECT_EQ(message({"--print-config", "--host=0.0.0.0"}), "accepted");
}

TEST(Config, NewKeyTakesOneName) {
    const auto result = parsed({"new-key", "alice"}, {{"PORT", "not a port"}});
    ASSERT_TRUE(std::holds_alternative<CommandLine>(result));
    EXPECT_EQ(std::get<CommandLine>(result).command, Command::kNewKey);
    EXPECT_EQ(std::get<CommandLine>(result).key_name, "alice");
    EXPECT_EQ(message({"new-key"}), "new-key needs one name, and nothing else");
    EXPECT_EQ(message({"new-key", "alice", "bob"}), "new-key needs one name, and nothing else");
}

}  // namespace
}  // namespace tuftwave::server
