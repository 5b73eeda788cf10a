#include "sheets/track_names.hpp"

#include <gtest/gtest.h>

namespace tuftwave::server::sheets {
namespace {

using Names = std::vector<std::string>;

TEST(TrackNames, AreTheBlocksInOrderOfAppearance) {
    EXPECT_EQ(track_names(Names{"b", "a", "b", "c", "a"}), (Names{"b", "a", "c"}));
}

TEST(TrackNames, AreTrimmedAndThenUnique) {
    EXPECT_EQ(track_names(Names{" a", "a\t\r\n", "\u3000a\u00a0 ", "a a", "前髪　"}), (Names{"a", "a a", "前髪"}));
}

TEST(TrackNames, ABlankNameIsHair) { EXPECT_EQ(track_names(Names{"", " \u3000", "hair"}), Names{"hair"}); }

}  // namespace
}  // namespace tuftwave::server::sheets
