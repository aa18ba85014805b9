#include "replays/render/colours/match_style.hpp"

#include "replays/render/colours/shared_colours.hpp"

namespace fulbito {
namespace {

/// The colours of a theme that the HTML page does not share.
struct OwnColours {
  Colour goal, ball_light, shadow, banner;
  TeamColours lone;
  Colour blue_goal, blue_ink, yellow_goal, yellow_ink;
};

/// A theme's style. Robot marks (disc and diamond) tell the teams apart even without colour.
constexpr MatchStyle styleWith(const SharedColours& shared, const OwnColours& own) {
  return {.page = shared.page,
          .panel = shared.panel,
          .rule = shared.rule,
          .text = shared.text,
          .dim_text = shared.dim,
          .field = {.wall = shared.wall,
                    .floor = shared.floor,
                    .left_goal = own.goal,
                    .right_goal = own.goal,
                    .line = shared.line},
          .teams = {TeamColours{.body = shared.blue,
                                .edge = shared.blue_edge,
                                .badge = shared.blue_badge,
                                .digit = shared.blue_digit,
                                .nose = shared.blue_badge,
                                .goal = own.blue_goal,
                                .ink = own.blue_ink},
                    TeamColours{.body = shared.yellow,
                                .edge = shared.yellow_edge,
                                .badge = shared.yellow_badge,
                                .digit = shared.yellow_digit,
                                .nose = shared.yellow_badge,
                                .goal = own.yellow_goal,
                                .ink = own.yellow_ink}},
          .lone = own.lone,
          .ball = shared.ball,
          .ball_edge = shared.seam,
          .ball_light = own.ball_light,
          .wheel = shared.wheel,
          .shadow = own.shadow,
          .banner = own.banner};
}

constexpr MatchStyle kDark = styleWith(kSharedDark, {.goal = opaque(0x12161b),
                                                     .ball_light = opaque(0xffc696),
                                                     .shadow = {0, 0, 0, 90},
                                                     .banner = withAlpha(kSharedDark.page, 226),
                                                     .lone = {.body = opaque(0xb0bac6),
                                                              .edge = opaque(0x2c323a),
                                                              .badge = opaque(0x20262d),
                                                              .digit = opaque(0xecf0f5),
                                                              .nose = opaque(0x20262d),
                                                              .goal = opaque(0x12161b),
                                                              .ink = opaque(0xe2e7ee)},
                                                     .blue_goal = opaque(0x18325e),
                                                     .blue_ink = opaque(0x6ea8ff),
                                                     .yellow_goal = opaque(0x5c4810),
                                                     .yellow_ink = opaque(0xffd040)});

constexpr MatchStyle kLight = styleWith(kSharedLight, {.goal = opaque(0xd3dae1),
                                                       .ball_light = opaque(0xffcea6),
                                                       .shadow = {40, 52, 66, 60},
                                                       .banner = withAlpha(kSharedLight.panel, 236),
                                                       .lone = {.body = opaque(0x7a8693),
                                                                .edge = opaque(0x343c46),
                                                                .badge = opaque(0xffffff),
                                                                .digit = opaque(0x181e26),
                                                                .nose = opaque(0xffffff),
                                                                .goal = opaque(0xd3dae1),
                                                                .ink = opaque(0x28303a)},
                                                       .blue_goal = opaque(0xaccaf5),
                                                       .blue_ink = opaque(0x1454be),
                                                       .yellow_goal = opaque(0xf6dd92),
                                                       .yellow_ink = opaque(0x8a6000)});

}  // namespace

const MatchStyle& styleOf(PictureTheme theme) { return theme == PictureTheme::kDark ? kDark : kLight; }

}  // namespace fulbito
