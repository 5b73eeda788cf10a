#include "gltf/json_text.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tuftwave::server::gltf {
namespace {

using Json = nlohmann::json;

void write_sample(JsonText& to) {
    to.open('{').key("a").open('[').next().number(1).next().number(0.1).next().number(std::size_t{7}).close(']');
    to.key("b").open('{').close('}').key("c").text("x\"\\\n髪").key("d").open('[').next().open('{').close('}').next();
    to.raw("null").close(']').close('}');
}

TEST(JsonText, WritesAsMuchAsItCounted) {
    JsonText counted;
    write_sample(counted);
    std::string text(counted.bytes(), '?');
    JsonText written(text.data());
    write_sample(written);
    EXPECT_EQ(written.bytes(), counted.bytes());
    EXPECT_EQ(text, R"({"a":[1,0.1,7],"b":{},"c":"x\"\\\n髪","d":[{},null]})");
}

TEST(JsonText, WritesNumbersAsTheJsonLibraryDoes) {
    for (const double number : {0.0, -0.0, 1.0, 1e-7, 123456789.0, 1e22, 0.1F * 1.0, -1.0 / 3}) {
        char digits[64];
        JsonText text(digits);
        text.number(number);
        EXPECT_EQ(std::string(digits, text.bytes()), Json(number).dump());
    }
}

TEST(ExtrasText, LeavesOutNullsAndEmptiesWhatIsEmpty) {
    EXPECT_EQ(extras_text(Json::parse(R"({"b":[1,null,"x"],"a":{"y":null},"n":null,"e":[],"t":true})")),
              R"({"a":null,"b":[1,"x"],"e":null,"t":true})");
    EXPECT_EQ(extras_text(Json{{"i", 2147483647}, {"w", 2147483648}, {"f", 0.5}}),
              R"({"f":0.5,"i":2147483647,"w":2147483648.0})");
}

}  // namespace
}  // namespace tuftwave::server::gltf
