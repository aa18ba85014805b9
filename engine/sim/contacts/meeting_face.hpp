#pragma once

class b2Contact;
struct b2Manifold;

namespace fulbito {

/// Makes two boxes push along the face that separates them better, whichever box the engine lists first. The
/// engine itself takes the first box's face unless the other is better by a tolerance. Two robots that push
/// front to front are always within it, so the first one would push straight, and win. Does nothing for
/// discs.
/// @param contact  as the engine has just found it
/// @param before  its points and impulses of the step before, with which the solver starts
void chooseMeetingFace(b2Contact& contact, const b2Manifold& before);

}  // namespace fulbito
