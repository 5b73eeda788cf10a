#include "character/accessor.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "character_samples.hpp"

namespace tuftwave::server::character {
namespace {

/// An accessor opened, or the fault that stands in the way.
struct Opened {
    explicit Opened(const Sample& sample, std::size_t index = 0) {
        std::optional<Fault> wrong;
        view = AccessorView::open({&sample.json, "", wrong}, index, sample.binary);
        fault = wrong;
    }

    std::optional<AccessorView> view;
    std::optional<Fault> fault;
};

template <class T>
Sample numbers(const std::vector<T>& values, int component, bool is_normalized = false) {
    Sample sample;
    sample.add_accessor(bytes_of(values), component, "SCALAR", values.size());
    if (is_normalized) sample.json["accessors"][0]["normalized"] = true;
    return sample;
}

template <class T>
void expect_numbers(const std::vector<T>& values, int component, const std::vector<double>& plain,
                    const std::vector<double>& normalized) {
    const Sample as_is = numbers(values, component), shares = numbers(values, component, true);
    const Opened first(as_is), second(shares);
    ASSERT_TRUE(first.view && second.view) << component;
    ASSERT_EQ(first.view->count(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_EQ(first.view->number(i, 0), plain[i]) << component << " " << i;
        EXPECT_EQ(second.view->number(i, 0), normalized[i]) << component << " " << i;
    }
}

TEST(Accessor, ReadsEveryComponentType) {
    expect_numbers<std::int8_t>({-128, -127, 0, 127}, kByte, {-128, -127, 0, 127}, {-1, -1, 0, 1});
    expect_numbers<std::uint8_t>({0, 51, 255}, kUnsignedByte, {0, 51, 255}, {0, 0.2, 1});
    expect_numbers<std::int16_t>({-32768, -32767, 32767}, kShort, {-32768, -32767, 32767}, {-1, -1, 1});
    expect_numbers<std::uint16_t>({0, 13107, 65535}, kUnsignedShort, {0, 13107, 65535}, {0, 0.2, 1});
    expect_numbers<std::uint32_t>({0, 4294967295U}, kUnsignedInt, {0, 4294967295.0}, {0, 1});
    expect_numbers<float>({-2.5F, 0.25F}, kFloat, {-2.5, 0.25}, {-2.5, 0.25});
}

TEST(Accessor, ReadsEveryWidth) {
    const std::pair<const char*, std::size_t> widths[] = {
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    for (const auto& [type, width] : widths) {
        std::vector<float> values(2 * width);
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
        Sample sample;
        sample.add_accessor(bytes_of(values), kFloat, type, 2);
        const Opened opened(sample);
        ASSERT_TRUE(opened.view) << type;
        EXPECT_EQ(opened.view->width(), width);
        EXPECT_EQ(opened.view->number(1, width - 1), static_cast<double>(2 * width - 1)) << type;
    }
}

TEST(Accessor, FollowsStrideAndOffsets) {
    Sample sample;
    sample.add_accessor(bytes_of<float>({9, 9}), kFloat, "SCALAR", 2);
    sample.add_accessor(bytes_of<float>({0, 1, 2, 3, 4, 5, 6}), kFloat, "VEC2", 2);
    sample.json["bufferViews"][1]["byteStride"] = 16;
    sample.json["accessors"][1]["byteOffset"] = 4;
    const Opened opened(sample, 1);
    ASSERT_TRUE(opened.view);
    EXPECT_EQ(opened.view->number(0, 0), 1);
    EXPECT_EQ(opened.view->number(0, 1), 2);
    EXPECT_EQ(opened.view->number(1, 0), 5);
    EXPECT_EQ(opened.view->number(1, 1), 6) << "the last element needs no whole stride";
}

TEST(Accessor, ReadsWhatIsNotAligned) {
    Sample sample;
    sample.add_accessor("x" + bytes_of<float>({1.5F}), kFloat, "SCALAR", 1);
    sample.json["accessors"][0]["byteOffset"] = 1;
    const Opened opened(sample);
    ASSERT_TRUE(opened.view);
    EXPECT_EQ(opened.view->number(0, 0), 1.5);
}

/// Three numbers of 4 bytes, then a JSON merge patch.
Sample patched(const char* patch) {
    Sample sample = numbers<float>({1, 2, 3}, kFloat);
    const FileJson changes = FileJson::parse(patch);
    for (const char* const list : {"accessors", "bufferViews"}) {
        if (changes.contains(list)) sample.json[list][0].merge_patch(changes[list]);
    }
    return sample;
}

TEST(Accessor, OutsideItsViewOrFileIsRefused) {
    const std::pair<const char*, const char*> rows[] = {
        {R"({"accessors": {"count": 4}})", "/accessors/0"},
        {R"({"accessors": {"byteOffset": 1}})", "/accessors/0"},
        {R"({"accessors": {"byteOffset": 4294967295}})", "/accessors/0"},
        {R"({"accessors": {"count": 4294967295}})", "/accessors/0"},
        {R"({"accessors": {"count": 4294967295, "byteOffset": 4294967295}})", "/accessors/0"},
        {R"({"accessors": {"count": 1073741825}})", "/accessors/0"},
        {R"({"accessors": {"count": 4294967296}})", "/accessors/0/count"},
        {R"({"accessors": {"byteOffset": -1}})", "/accessors/0/byteOffset"},
        {R"({"accessors": {"bufferView": 1}})", "/accessors/0/bufferView"},
        {R"({"accessors": {"componentType": 5124}})", "/accessors/0/componentType"},
        {R"({"accessors": {"componentType": 0}})", "/accessors/0/componentType"},
        {R"({"accessors": {"normalized": 1}})", "/accessors/0/normalized"},
        {R"({"bufferViews": {"byteStride": 8}})", "/accessors/0"},
        {R"({"bufferViews": {"byteStride": 253}})", "/bufferViews/0/byteStride"},
        {R"({"bufferViews": {"byteLength": 13}})", "/bufferViews/0"},
        {R"({"bufferViews": {"byteOffset": 1}})", "/bufferViews/0"},
        {R"({"bufferViews": {"byteOffset": 4294967295, "byteLength": 12}})", "/bufferViews/0"},
        {R"({"bufferViews": {"byteOffset": 4294967290, "byteLength": 4294967295}})", "/bufferViews/0"},
    };
    for (const auto& [patch, pointer] : rows) {
        const Sample sample = patched(patch);
        const Opened opened(sample);
        ASSERT_TRUE(opened.fault) << patch;
        EXPECT_EQ(opened.fault->kind, std::string_view(pointer).ends_with("normalized") ? Fault::Kind::kWrongType
                                                                                        : Fault::Kind::kOutOfRange);
        EXPECT_EQ(opened.fault->pointer, pointer) << patch;
    }
}

TEST(Accessor, ThatLiesElsewhereIsPassedOver) {
    for (const char* const patch :
         {R"({"accessors": {"sparse": {"count": 1}}})", R"({"accessors": {"bufferView": null}})",
          R"({"bufferViews": {"buffer": 1, "byteLength": 4000}})",
          R"({"bufferViews": {"extensions": {"EXT_meshopt_compression": {}}}})", R"({"accessors": {"type": "MAT3"}})",
          R"({"accessors": {"count": 0}})", R"({"bufferViews": {"byteStride": 3}})"}) {
        const Sample sample = patched(patch);
        const Opened opened(sample);
        EXPECT_FALSE(opened.view) << patch;
        EXPECT_FALSE(opened.fault) << patch;
    }
}

}  // namespace
}  // namespace tuftwave::server::character
