#include "sheets/csv.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace tuftwave::server::sheets {
namespace {

Schedule example() { return *make_schedule({}, Formulas::kCorrected, {}); }  // T 0.45, 24 fps, on twos

TEST(Csv, HasARowPerFrameCountedFromOne) {
    EXPECT_EQ(csv(example(), 1),
              "frame,picture,key\r\n1,1,1\r\n2,1,0\r\n3,2,1\r\n4,2,0\r\n5,3,1\r\n6,3,0\r\n7,4,1\r\n8,4,0\r\n9,5,"
              "1\r\n10,5,0\r\n11,6,1\r\n");
}

TEST(Csv, RepeatsWithoutAGap) {
    std::istringstream rows(csv(example(), 2));
    std::string row;
    for (int i = 0; i <= 12; ++i) std::getline(rows, row);
    EXPECT_EQ(row, "12,1,1\r");
}

}  // namespace
}  // namespace tuftwave::server::sheets
