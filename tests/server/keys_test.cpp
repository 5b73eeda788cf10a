#include "access/keys.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <variant>
#include <vector>

namespace tuftwave::server {
namespace {

const std::string kOldKey = "a-key-that-was-first", kNewKey = "a-key-that-was-later";  // 20 characters each
// What sha256sum says of them.
const std::string kOldHash = "f1c5d78229ec1a8aae0df921060cbb861039a8d9b337226689b9344643195023";
const std::string kNewHash = "42cdc1b073e02e6c61271ef234aacea8df6d29f1e692d09e70d19049d580dd4e";

std::string error_of(const std::string& text) {
    const auto keys = Keys::parse(text);
    const auto* error = std::get_if<KeyFileError>(&keys);
    return error ? error->message : "accepted";
}

Keys keys_of(const std::string& text) {
    auto keys = Keys::parse(text);
    if (const auto* error = std::get_if<KeyFileError>(&keys)) ADD_FAILURE() << error->message;
    return std::holds_alternative<Keys>(keys) ? std::get<Keys>(keys) : Keys{};
}

TEST(Keys, SeveralAreValidAtOnce) {
    const Keys keys =
        keys_of("# spring\nold " + kOldHash + "\n\n  new\t" + kNewHash + "  2.5 \r\n# " + kOldHash + "\n");
    ASSERT_EQ(keys.size(), 2u);
    EXPECT_EQ(keys.find(kOldKey), 0u);
    EXPECT_EQ(keys.find(kNewKey), 1u);
    EXPECT_EQ(keys.at(0).name, "old");
    EXPECT_FALSE(keys.at(0).rate);
    EXPECT_EQ(keys.at(1).rate, 2.5);
}

TEST(Keys, NothingElseIsFound) {
    const Keys keys = keys_of("old " + kOldHash + "\nnew " + kNewHash + "\n");
    for (const std::string& other : {kOldKey.substr(1), kOldKey + "x", kOldHash, std::string(), std::string("old")})
        EXPECT_FALSE(keys.find(other)) << other;
    EXPECT_FALSE(Keys().find(kOldKey));
}

TEST(Keys, HashMayBeInCapitals) {
    std::string hash = kOldHash;
    for (char& c : hash) c = static_cast<char>(std::toupper(c));
    EXPECT_EQ(keys_of("old " + hash).find(kOldKey), 0u);
}

TEST(Keys, BadLineIsNamedByItsNumberOnly) {
    const std::string good = "old " + kOldHash + "\n";
    const std::vector<std::pair<std::string, std::string>> table{
        {"old", "line 1 of the key file: expected NAME SHA256 [RATE]"},
        {good + "# \n" + kNewKey, "line 3 of the key file: expected NAME SHA256 [RATE]"},
        {good + "new " + kNewHash + " 1 2", "line 2 of the key file: expected NAME SHA256 [RATE]"},
        {good + "n/w " + kNewHash, "line 2 of the key file: a name has 1 to 64 of A-Z a-z 0-9 . _ -"},
        {std::string(65, 'n') + " " + kNewHash, "line 1 of the key file: a name has 1 to 64 of A-Z a-z 0-9 . _ -"},
        {good + "new " + kNewKey, "line 2 of the key file: the hash is not 64 hexadecimal digits"},
        {"new " + kNewHash.substr(1) + "g", "line 1 of the key file: the hash is not 64 hexadecimal digits"},
        {"new -" + kNewHash.substr(1), "line 1 of the key file: the hash is not 64 hexadecimal digits"},
        {"new " + kNewHash + "0", "line 1 of the key file: the hash is not 64 hexadecimal digits"},
        {"new " + kNewHash + " fast", "line 1 of the key file: the rate is not a number from 0 to 1000000"},
        {"new " + kNewHash + " -1", "line 1 of the key file: the rate is not a number from 0 to 1000000"},
        {"new " + kNewHash + " nan", "line 1 of the key file: the rate is not a number from 0 to 1000000"},
        {"new " + kNewHash + " inf", "line 1 of the key file: the rate is not a number from 0 to 1000000"},
        {good + "old " + kNewHash, "line 2 of the key file: the name stands in an earlier line"},
        {good + "new " + kOldHash, "line 2 of the key file: the hash stands in an earlier line"},
        {"", "the key file has no key; tuftwave-server new-key NAME makes one"},
        {"# " + good, "the key file has no key; tuftwave-server new-key NAME makes one"},
    };
    for (const auto& [text, message] : table) EXPECT_EQ(error_of(text), message) << text;
}

TEST(Keys, AThousandAreTheMost) {
    std::string text;
    for (int i = 0; i < 1'000; ++i) {
        std::string hash = kOldHash;
        hash.replace(0, 4, std::to_string(1'000 + i));
        text += "k" + std::to_string(i) + " " + hash + "\n";
    }
    EXPECT_EQ(keys_of(text).size(), 1'000u);
    EXPECT_EQ(error_of(text + "one " + kNewHash), "line 1001 of the key file: there are more than 1000 keys");
}

/// A file of its own that is gone afterwards.
class File {
  public:
    File(const std::string& text, const mode_t mode) {
        const int descriptor = ::mkstemp(path_.data());
        EXPECT_GE(descriptor, 0);
        EXPECT_EQ(::write(descriptor, text.data(), text.size()), static_cast<ssize_t>(text.size()));
        EXPECT_EQ(::fchmod(descriptor, mode), 0);
        ::close(descriptor);
    }
    ~File() { ::unlink(path_.c_str()); }
    const std::string& path() const { return path_; }

  private:
    std::string path_ = testing::TempDir() + "keys-XXXXXX";
};

TEST(KeyFile, WarnsWhereOthersMayReadOrChangeIt) {
    for (const mode_t mode : {0600u, 0400u, 0640u, 0644u, 0602u, 0620u}) {
        const File file("old " + kOldHash + "\n", mode);
        const auto read = read_key_file(file.path());
        ASSERT_TRUE(std::holds_alternative<KeyFile>(read)) << std::oct << mode;
        const KeyFile& made = std::get<KeyFile>(read);
        EXPECT_EQ(made.keys.find(kOldKey), 0u);
        EXPECT_EQ(made.warning.empty(), mode == 0600 || mode == 0400 || mode == 0640) << std::oct << mode;
        EXPECT_EQ(made.warning.find(file.path()), std::string::npos);
    }
}

TEST(KeyFile, IsRefusedWhereItCannotBeReadOrIsTooLong) {
    const File long_one(std::string(1024 * 1024 + 5'000, '\n'), 0600);
    for (const std::string& path : {long_one.path(), testing::TempDir() + "no-such-file", testing::TempDir()}) {
        const auto read = read_key_file(path);
        ASSERT_TRUE(std::holds_alternative<KeyFileError>(read)) << path;
        EXPECT_EQ(std::get<KeyFileError>(read).message, "the key file cannot be read, or is longer than 1 MiB");
    }
}

TEST(KeyFile, SaysWhichLineIsBad) {
    const File file("old " + kOldHash + "\n" + kNewKey + "\n", 0600);
    const auto read = read_key_file(file.path());
    ASSERT_TRUE(std::holds_alternative<KeyFileError>(read));
    EXPECT_EQ(std::get<KeyFileError>(read).message, "line 2 of the key file: expected NAME SHA256 [RATE]");
}

TEST(Credentials, AreExactlyOneBearerOf20To200VisibleCharacters) {
    const std::string most(200, 'x');
    for (const std::string& good : {"Bearer " + kOldKey, "bearer " + kOldKey, "BEARER   " + kOldKey}) {
        const NameValues headers{{"accept", "*/*"}, {"authorization", good}};
        EXPECT_EQ(credentials_of(headers).key, kOldKey) << good;
        EXPECT_TRUE(credentials_of(headers).is_given);
    }
    const NameValues longest{{"authorization", "Bearer " + most}};
    EXPECT_EQ(credentials_of(longest).key, most);

    const std::vector<std::string> bad{
        "",
        "Bearer",
        "Bearer ",
        kOldKey,
        "Bearer" + kOldKey,
        "Bearer\t" + kOldKey.substr(1) + "\t",
        "Bearer " + kOldKey.substr(1),
        "Bearer " + most + "x",
        "Bearer " + kOldKey + " ",
        "Bearer " + kOldKey + ", Bearer " + kOldKey,
        "Bearer a key with blanks within it",
        "Bearer a-key-that-is-not-\xc3\xa4scii",
        "Bearer a-key-with-control\x01",
        "Basic " + kOldKey,
        "Bearers " + kOldKey,
        "Beare " + kOldKey,
    };
    for (const std::string& value : bad) {
        const NameValues headers{{"authorization", value}};
        EXPECT_EQ(credentials_of(headers).key, "") << value;
        EXPECT_TRUE(credentials_of(headers).is_given) << value;
    }
    const NameValues twice{{"authorization", "Bearer " + kOldKey}, {"authorization", "Bearer " + kOldKey}};
    EXPECT_EQ(credentials_of(twice).key, "");
    EXPECT_TRUE(credentials_of(twice).is_given);
    EXPECT_FALSE(credentials_of({{"x-authorization", "Bearer " + kOldKey}}).is_given);
    EXPECT_EQ(credentials_of({{"proxy-authorization", "Bearer " + kOldKey}}).key, "");
}

}  // namespace
}  // namespace tuftwave::server
