#include "replays/render/match_style.hpp"

namespace fulbito {
namespace {

// Blue and yellow differ in every kind of colour vision; where hues fail (tritan) they differ in lightness.
// The marks - disc and diamond - tell the teams apart without any colour.
constexpr MatchStyle kDark{.page = {13, 16, 21},
                           .panel = {22, 27, 34},
                           .rule = {48, 56, 67},
                           .text = {236, 240, 245},
                           .dim_text = {148, 160, 174},
                           .field = {.wall = {60, 69, 81},
                                     .floor = {27, 33, 40},
                                     .left_goal = {18, 22, 27},
                                     .right_goal = {18, 22, 27},
                                     .line = {150, 160, 171}},
                           .teams = {TeamColours{.body = {52, 130, 246},
                                                 .edge = {9, 32, 74},
                                                 .badge = {255, 255, 255},
                                                 .digit = {14, 52, 122},
                                                 .nose = {255, 255, 255},
                                                 .goal = {24, 50, 94}},
                                     TeamColours{.body = {255, 200, 24},
                                                 .edge = {84, 58, 0},
                                                 .badge = {38, 30, 6},
                                                 .digit = {255, 226, 120},
                                                 .nose = {38, 30, 6},
                                                 .goal = {92, 72, 16}}},
                           .lone = {.body = {176, 186, 198},
                                    .edge = {44, 50, 58},
                                    .badge = {32, 38, 45},
                                    .digit = {236, 240, 245},
                                    .nose = {32, 38, 45},
                                    .goal = {18, 22, 27}},
                           .ball = {255, 118, 28},
                           .ball_edge = {122, 44, 0},
                           .ball_light = {255, 198, 150},
                           .wheel = {64, 71, 80},
                           .shadow = {0, 0, 0, 90},
                           .banner = {13, 16, 21, 226}};

constexpr MatchStyle kLight{.page = {244, 246, 248},
                            .panel = {255, 255, 255},
                            .rule = {214, 220, 227},
                            .text = {24, 30, 38},
                            .dim_text = {94, 105, 118},
                            .field = {.wall = {176, 186, 197},
                                      .floor = {230, 235, 239},
                                      .left_goal = {211, 218, 225},
                                      .right_goal = {211, 218, 225},
                                      .line = {158, 170, 182}},
                            .teams = {TeamColours{.body = {32, 108, 226},
                                                  .edge = {8, 38, 92},
                                                  .badge = {255, 255, 255},
                                                  .digit = {14, 52, 122},
                                                  .nose = {255, 255, 255},
                                                  .goal = {172, 202, 245}},
                                      TeamColours{.body = {250, 190, 8},
                                                  .edge = {104, 72, 0},
                                                  .badge = {44, 34, 4},
                                                  .digit = {255, 226, 120},
                                                  .nose = {44, 34, 4},
                                                  .goal = {246, 221, 146}}},
                            .lone = {.body = {122, 134, 147},
                                     .edge = {52, 60, 70},
                                     .badge = {255, 255, 255},
                                     .digit = {24, 30, 38},
                                     .nose = {255, 255, 255},
                                     .goal = {211, 218, 225}},
                            .ball = {246, 104, 10},
                            .ball_edge = {124, 46, 0},
                            .ball_light = {255, 206, 166},
                            .wheel = {78, 86, 96},
                            .shadow = {40, 52, 66, 60},
                            .banner = {255, 255, 255, 236}};

}  // namespace

const MatchStyle& styleOf(PictureTheme theme) { return theme == PictureTheme::kDark ? kDark : kLight; }

}  // namespace fulbito
