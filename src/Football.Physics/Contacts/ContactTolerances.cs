namespace FootballPhysics.Contacts;

/// <summary>All tolerances of contacts, as one ladder: per unit, from the smallest to the largest.</summary>
/// <remarks>
/// Each entry states the fault of a larger value (above) and of a smaller one (below). The order of the gaps matters: rounding of a position on a
/// pitch (1e-14 m) &lt; <see cref="LocatedGap"/> &lt; <see cref="ClosedGap"/> &lt; <see cref="Touching"/> &lt; <see cref="Overlap"/> &lt;
/// the depths that only piles and displays allow. ContactToleranceTests checks the order.
/// </remarks>
internal static class ContactTolerances
{
    // ---- Gaps, m ----

    /// <summary>The error of a group's positions and speeds that is not corrected, m and m/s.</summary>
    /// <remarks>Above: balls in contact drift apart over many steps. Below: rounding keeps the projection busy to its last round.</remarks>
    public const double ProjectionError = 1e-15;

    /// <summary>The gap at which the time of an event is exact, m.</summary>
    /// <remarks>Above: the time of an impact loses digits. Below: the search runs into rounding of the position.</remarks>
    public const double LocatedGap = 1e-14;

    /// <summary>The gap at which the time of a contact of two balls is exact, m; and the time between two impacts of one instant, s.</summary>
    /// <remarks>Above: the times of a chain of balls lose digits. Below: rounding splits simultaneous impacts.</remarks>
    public const double BallsTouch = 1e-13;

    /// <summary>The gap at which a ball is exactly on a surface, m. Two depths that differ by less are equal.</summary>
    /// <remarks>Above: a projected ball stays so far off that its next contact is late, or the lower of two tiles carries it. Below: two surfaces cannot
    /// be met within rounding, which then chooses between flush tiles.</remarks>
    public const double ClosedGap = 1e-12;

    /// <summary>The minimum distance beyond an edge at which a piece ends, m.</summary>
    /// <remarks>Above: the ball passes a narrow next tile. Below: rounding keeps the ball on this side, and pieces of no length follow.</remarks>
    public const double LeastBeyondEdge = 1e-12;

    /// <summary>The ball touches a surface if the gap is below this, m.</summary>
    /// <remarks>Above: impacts come early, and tiles lower by less than this count as flush. Below: a projected ball (<see cref="ClosedGap"/>)
    /// no longer touches its carrier after a piece.</remarks>
    public const double Touching = 1e-10;

    /// <summary>A smaller overlap is rounding or contact, and is not corrected, m. The maximum depth of a ball of a pile in stationary
    /// surfaces.</summary>
    /// <remarks>Above: a ball stays inside a surface and hits it again. Below <see cref="Touching"/>: a ball in contact is displaced in every
    /// step.</remarks>
    public const double Overlap = 5e-10;

    /// <summary>The maximum separation of two surfaces with the same normal until they are compared again, m.</summary>
    /// <remarks>Above: a curved seam is left unnoticed. Below: a ball that crosses a seam is checked many times.</remarks>
    public const double PartedSurfaces = 1e-8;

    /// <summary>The extra closing allowed for a slow gap to a rotating shape before the next evaluation, m.</summary>
    /// <remarks>Above: a contact is late by this gap at the next evaluation. Below: a ball that touches a drum needs many evaluations.</remarks>
    public const double SlowSink = 1e-8;

    /// <summary>The maximum rise of a touched hollow surface between two evaluations of a search, m.</summary>
    /// <remarks>Above: a ball passes through a lower bump. Below: a search along the surface takes thousands of evaluations.</remarks>
    public const double RiseAlong = 1e-8;

    /// <summary>The overlap of two balls of a pile at which the separation goes on, m.</summary>
    /// <remarks>Above: overlaps grow visibly in high piles. Below: the rounds run out in large ones.</remarks>
    public const double PileOverlap = 1e-7;

    /// <summary>The maximum depth of a reported path in a stationary object, m.</summary>
    /// <remarks>Above: a displayed ball enters a wall. Below: paths that only touch are corrected.</remarks>
    public const double ShownDepth = 1e-7;

    /// <summary>The maximum distance between the path of a piece in a net and the polynomial through its ends, m.</summary>
    /// <remarks>Above: a contact near the net is missed or late. Below: a step in a net takes more pieces.</remarks>
    public const double NetBend = 3e-7;

    /// <summary>The upper bound of the projection onto the carrier after a piece, m.</summary>
    /// <remarks>Above: a ball behind the mouth of a goal could enter it from behind. Below: a goal is missed after a projection at its
    /// mouth.</remarks>
    public const double Projected = 1e-6;

    /// <summary>The overlap that is no contact, m: two balls are separated even if they do not close, and a moving object squeezes a ball of a pile.</summary>
    /// <remarks>Above: balls stay visibly inside each other, or roll inside an object. Below: the error of a part counts as an overlap.</remarks>
    public const double BallOverlap = 1e-6;

    /// <summary>The maximum gap of two balls in sustained contact, m.</summary>
    /// <remarks>Above: balls that pass each other form a pile. Below: a pile falls apart by the error of a part.</remarks>
    public const double Leaning = 1e-6;

    /// <summary>The maximum distance of a ball from its carrier in a valid state, per metre of its coordinates, m.</summary>
    /// <remarks>Above: a wrong state passes the check. Below: rounding and the integrator's error fail it.</remarks>
    public const double CarrierDistance = 1e-6;

    /// <summary>The margin of a pile's search for contacts beyond the motion of the balls, m.</summary>
    /// <remarks>Above: the solver gets more contacts without load. Below: a contact is missed if a push moves a ball farther than predicted.</remarks>
    public const double PileMargin = 1e-5;

    /// <summary>The gap below which the displayed path of a squeezed ball follows a stationary surface, m.</summary>
    /// <remarks>Above: a path that approaches a wall bends too early. Below: a path along a wall zigzags.</remarks>
    public const double ShownContact = 1e-4;

    /// <summary>The maximum gap at which a surface is a contact of a ball that rattles, m.</summary>
    /// <remarks>The ball will touch the surface again, too gently for a bounce. Above: the ball follows a surface that it left. Below: contact
    /// and flight alternate.</remarks>
    public const double Rattling = 2e-4;

    // ---- Speeds in m/s; spins, multiplied by the radius ----

    /// <summary>The speed below which a ball is at a standstill, and the change below which its motion is the same, m/s; for spins, times the radius.</summary>
    /// <remarks>Above: a creeping ball stops. Below: rounding keeps a ball moving, and each piece computes its rates twice.</remarks>
    public const double Standstill = 1e-12;

    /// <summary>A closing speed below this counts as zero, m/s.</summary>
    /// <remarks>Above: a slow ball sinks in without an impact. Below: rounding of a resting ball counts as an impact.</remarks>
    public const double Approaching = 1e-9;

    /// <summary>A ball with a smaller slip rolls, m/s; a smaller spin about the normal, in rad/s, counts as zero.</summary>
    /// <remarks>Above: the end of a slide comes early. Below: the direction of the slip is rounding.</remarks>
    public const double Rolling = 1e-9;

    /// <summary>The change of the velocity at which the removal of slips and normal speeds of a set ends, m/s.</summary>
    /// <remarks>Above: a ball held by several surfaces slips. Below: wedges take the maximum number of rounds.</remarks>
    public const double SlipRemoval = 1e-9;

    /// <summary>A slip on one of several surfaces below this has ended, m/s.</summary>
    /// <remarks>Above: slides end early. Below: a turning slip takes ever shorter pieces.</remarks>
    public const double Sticking = 1e-7;

    /// <summary>The component across the push of a slow slip that follows it in a hollow, m/s.</summary>
    /// <remarks>Above: the velocity of a ball that loses its grip is off. Below: the pieces follow the direction of the slip, and a step has thousands.</remarks>
    public const double SlowSlip = 1e-7;

    /// <summary>After many pieces, a turning slip ends at this larger value, m/s.</summary>
    /// <remarks>Above: the end of the slip is visible in the path. Below: the pieces of a step run out.</remarks>
    public const double StickingAfterMany = 1e-6;

    /// <summary>A slip below this is the error of the solver, m/s: the ball rolls.</summary>
    /// <remarks>Above: a slow slide is reported as a roll. Below: a roll in a set is reported as a slide.</remarks>
    public const double SolvedSlip = 1e-6;

    /// <summary>The maximum closing speed of a solved set, m/s.</summary>
    /// <remarks>Above: a set without a solution passes, and the ball sinks in. Below: the solver's error fails a solved set. In a set
    /// without a solution the loads grow without bound, so their relative changes become small too.</remarks>
    public const double LargestClosing = 1e-6;

    /// <summary>The minimum speed used to convert a distance to a time, m/s.</summary>
    /// <remarks>Above: a slow ball stops short of an edge. Below: a piece of a ball at rest has no end.</remarks>
    public const double SlowestAtEdge = 1e-6;

    /// <summary>A separating speed below this counts as zero, m/s: 5e-12 m in a microsecond.</summary>
    /// <remarks>Above: a ball that leaves slowly is held down. Below: rounding of an impact lifts a ball that stays.</remarks>
    public const double Leaving = 5e-6;

    /// <summary>The maximum relative speed of two balls in sustained contact, m/s.</summary>
    /// <remarks>Above: balls that hit each other overlap within a part. Below: the error of pressed balls grows from second order to first.</remarks>
    public const double Pressing = 3e-5;

    /// <summary>A rolling ball on several surfaces is reported as sliding above this slip, m/s.</summary>
    /// <remarks>Above: a slide is not reported. Below: a slip that ends in the next part is.</remarks>
    public const double ReportedSlip = 1e-3;

    // ---- Times, s ----

    /// <summary>The minimum step of a search, s.</summary>
    /// <remarks>Above: not reached. At zero, a search on a path of no length would not end.</remarks>
    public const double ShortestStep = 1e-300;

    /// <summary>The minimum step length used to convert a jump in the velocity to an acceleration, s.</summary>
    /// <remarks>Above: not reached. Below: the square overflows.</remarks>
    public const double ShortestForJumps = 1e-100;

    /// <summary>The tolerance for the end of a slide in closed form, s, for a step of 20 ms.</summary>
    /// <remarks>
    /// The closed form requires a push on the slip that is this constant. Above: the step loses its order. Below: slides end by the search, which costs
    /// more. For other steps the tolerance scales with the step length to the power of the integrator's order.
    /// </remarks>
    public const double SlideEnd = 1e-10;

    /// <summary>Impacts that follow one another within this time count as one instant, s.</summary>
    /// <remarks>Above: a fast rattle counts as one instant. Below: impacts between two surfaces that close never end.</remarks>
    public const double AtOnce = 1e-9;

    /// <summary>The error of the time at which a slide in a net ends in closed form, s.</summary>
    /// <remarks>Above: the velocity after the slide loses digits. Below: the slide takes more parts.</remarks>
    public const double NetSlideEnd = 1e-9;

    /// <summary><see cref="SlideEnd"/> for integrators of an order below four, s.</summary>
    public const double CoarseSlideEnd = 1e-7;

    /// <summary>The minimum advance of the search for a contact of two balls, s.</summary>
    /// <remarks>Above: fast balls pass through each other's edge. Below: balls that touch without closing take many steps.</remarks>
    public const double ShortestAdvance = 1e-7;

    /// <summary>A ball that would return to the ground sooner than this stays down, s.</summary>
    /// <remarks>Above: small hops vanish. Below: the number of impacts per step grows without bound under large gravity.</remarks>
    public const double ShortestHop = 1e-6;

    /// <summary>The duration assigned to a displacement for the path search, s. The displacement itself takes no time.</summary>
    /// <remarks>Above: closing speeds of small displacements fall below <see cref="Approaching"/>. Below: rounding of the path grows.</remarks>
    public const double Displacement = 1e-6;

    /// <summary>The longest closed-form end of a slide on a curved surface, s.</summary>
    /// <remarks>Above: the push changes with the position meanwhile. Below: the search takes more pieces.</remarks>
    public const double CurvedSlideEnd = 1.25e-5;

    /// <summary>The contact time of two balls is searched within this interval around the estimate from the paths, s.</summary>
    /// <remarks>Above: the search finds another contact. Below: it misses the contact after a curved path.</remarks>
    public const double NearbyTime = 1e-3;

    /// <summary>A ball pressed by a force other than its weight stays on a surface if it would return within this time, s.</summary>
    /// <remarks>Above: hops along a windy wall vanish. Below: a pressed ball rattles.</remarks>
    public const double ShortestPressedHop = 1e-3;

    // ---- Accelerations, m/s² ----

    /// <summary>A load or a friction margin below this counts as zero, m/s².</summary>
    /// <remarks>Above: a light ball leaves its surface. Below: rounding of cancelling forces holds it.</remarks>
    public const double LeastLoad = 1e-9;

    // ---- Curvatures, 1/m ----

    /// <summary>Two curvatures are equal within this.</summary>
    /// <remarks>Above: a ball rolls below a wide hollow. Below: rounding chooses between surfaces.</remarks>
    public const double SameBend = 1e-6;

    // ---- Directions: sines, cosines and determinants of unit vectors ----

    /// <summary>The difference of two unit vectors below which a slip starts in the same direction.</summary>
    /// <remarks>Above: the start of the slip is off. Below: the iteration does not end.</remarks>
    public const double SameDirection = 1e-12;

    /// <summary>The squared sine below which a push is along the normal, so that nothing is left beside it.</summary>
    /// <remarks>Above: a steep push is dropped. Below: a direction is divided by rounding.</remarks>
    public const double AlongNormal = 1e-12;

    /// <summary>Two normals are equal if 1 − n₁·n₂ is below this.</summary>
    /// <remarks>
    /// The ball touches the edge of the next tile 1e-10 m before it is on it, at an angle of 4e-5 rad. For a tile that is 1e-10 m higher, the angle is 6e-5
    /// rad, where n₁·n₂ is 1 − 1.8e-9. Below that, flush seams cause impacts. Above: real edges cause none.
    /// </remarks>
    public const double SameNormal = 4e-9;

    /// <summary>Normals whose angle has a smaller sine than this belong to one face or to coinciding surfaces.</summary>
    /// <remarks>Above: two faces are treated as one. Below: rounding splits a face.</remarks>
    public const double Coincident = 1e-8;

    /// <summary>Normals are independent if |n₁ × n₂|, 1 − (n₁·n₂)² or |n₁·(n₂ × n₃)| exceeds this.</summary>
    /// <remarks>Above: narrow wedges are treated as one surface. Below: the solution is amplified rounding.</remarks>
    public const double Independent = 1e-6;

    /// <summary>A plane whose normal has a smaller y than this is a wall: no position is above it.</summary>
    /// <remarks>Above: steep ground counts as a wall. Below: the height above it overflows.</remarks>
    public const double Wall = 1e-6;

    // ---- Shares, relative to the quantity in question ----

    /// <summary>The advance of a search relative to the time, at late times, where the clock is coarse.</summary>
    /// <remarks>Above: contacts at late times are skipped. Below: the time does not change, and the search does not end.</remarks>
    public const double ClockRounding = 5e-16;

    /// <summary>The gap to the ground at which a ball is on it, relative to the height or to 1 m.</summary>
    /// <remarks>Above: the ball starts above the ground. Below: rounding prevents an end.</remarks>
    public const double OnGround = 1e-14;

    /// <summary>The change of impulses and speeds below which the solver of a set has converged.</summary>
    /// <remarks>Above: squeezed balls gain energy. Below: rounding prevents an end.</remarks>
    public const double Settled = 1e-13;

    /// <summary>The bracket at which the search for an event on surfaces ends, relative to the piece.</summary>
    /// <remarks>Above: the time of the event loses digits. Below: rounding of the loads prevents an end.</remarks>
    public const double EventWidth = 1e-12;

    /// <summary>The excess of the energy over the energy of rest at which a ball still rests.</summary>
    /// <remarks>Above: moving balls come to rest. Below: a ball that is located at that energy does not.</remarks>
    public const double AtRest = 1e-12;

    /// <summary>The excess of a force over its friction cone that is rounding.</summary>
    /// <remarks>Above: friction exceeds the law. Below: a force on the cone counts as outside.</remarks>
    public const double BeyondCone = 1e-12;

    /// <summary>The tension of a net, 1 + b δ̇, below which the kink of its force is located.</summary>
    /// <remarks>Above: the integrator loses its order at the kink. Below: rounding of the speed prevents an end.</remarks>
    public const double NetSlack = 1e-10;

    /// <summary>A piece that starts with a smaller tension than this starts at the kink of a net's force.</summary>
    /// <remarks>Above: a kink soon after the start is missed. Below <see cref="NetSlack"/>: the kink is located again.</remarks>
    public const double AtNetSlack = 1e-9;

    /// <summary>If a pivot is below this share of the largest entry, the solution is not unique.</summary>
    /// <remarks>Above: unique loads are shared by least squares. Below: undetermined loads are amplified rounding.</remarks>
    public const double Singular = 1e-9;

    /// <summary>Two loads, or two friction impulses, are equal if they differ by less than this share; the first contact then has priority.</summary>
    /// <remarks>Above: a lighter contact is the carrier. Below: rounding chooses between equal loads.</remarks>
    public const double SameLoad = 1e-9;

    /// <summary>The share of a friction cone that forces keep clear, of its square.</summary>
    /// <remarks>Above: friction is weaker than the law. Below: the moved force is outside by rounding.</remarks>
    public const double InsideCone = 1e-9;

    /// <summary>The share of the free acceleration that a held ball may keep.</summary>
    /// <remarks>Above: a starting ball counts as held. Below: the solver's error frees a held one.</remarks>
    public const double StillHeld = 1e-9;

    /// <summary>The share of a step, a part or a piece within which a time counts as its end.</summary>
    /// <remarks>Above: a run ends early. Below: rounding of the clock adds a step of no length.</remarks>
    public const double StepRounding = 1e-9;

    /// <summary>A piece ends this share of its length beyond an edge or an event, so that the next piece starts beyond it.</summary>
    /// <remarks>Above: the ball passes a following event. Below: rounding keeps the ball before the event.</remarks>
    public const double Beyond = 1e-9;

    /// <summary>The convergence of impulses that only locate the evaluation at the end of a part, or after the last iteration.</summary>
    /// <remarks>
    /// Undetermined loads, such as those of a ball between a player and a post, converge slowly. Above: the loads are visibly wrong. Below: the iterations
    /// run out, and the set counts as unsolved.
    /// </remarks>
    public const double Foreseen = 1e-8;

    /// <summary>The bracket at which the search for a jump in the load ends, relative to the piece.</summary>
    /// <remarks>Above: the ball is behind the edge. Below: more evaluations, for a position that an edge does not define.</remarks>
    public const double JumpWidth = 1e-8;

    /// <summary>The gain of energy on stationary contacts above which a piece is taken again in parts, and the result of a part is scaled, relative.</summary>
    /// <remarks>Above: a ball that is clamped gains energy. Below: the error of the integrator is taken for a gain.</remarks>
    public const double PieceEnergy = 1e-7;

    /// <summary>The minimum step of a search, relative to the path.</summary>
    /// <remarks>Above: a contact between two steps is skipped. Below: a ball that touches without closing takes many steps.</remarks>
    public const double ShortestShare = 1e-7;

    /// <summary>After a jump in the load, the piece ends this share of its length beyond the jump; more than <see cref="JumpWidth"/>.</summary>
    /// <remarks>Above: the ball passes over the next face. Below: the next piece starts before the edge again.</remarks>
    public const double BeyondJump = 1e-7;

    /// <summary>A piece that ends at a grazing contact keeps at least this share of its length.</summary>
    /// <remarks>Above: the contact is passed. Below: pieces of no length use up the step.</remarks>
    public const double ShortestPiece = 1e-6;

    /// <summary>The regularisation of G Gᵀ, relative to its diagonal; iterative refinement removes its effect.</summary>
    /// <remarks>Above: the refinement does not converge. Below: the system is singular.</remarks>
    public const double Ridge = 1e-6;

    /// <summary>A cleared pile may take this share less than its longest step.</summary>
    /// <remarks>Above: steps are checked more often. Below: rounding of the clock exceeds the longest step.</remarks>
    public const double WithinLongest = 1e-6;

    /// <summary>The solver of a pile stops if a change of speed is below this share of the change by the forces in a part.</summary>
    /// <remarks>Above: a pile creeps. Below: the rounds run out.</remarks>
    public const double PileSettled = 1e-5;

    /// <summary>A piece ends this share of its length before a jump of the curvature.</summary>
    /// <remarks>Above: the next piece, across the jump, is long. Below: a stage of the integrator is beyond the jump.</remarks>
    public const double BeforeBend = 1e-5;

    /// <summary>A pile rests if, with its contacts, each ball keeps at most this share of the forces on it; so does a squeezed ball among stationary objects.</summary>
    /// <remarks>Above: a falling pile rests. Below: the solver's error keeps a pile awake.</remarks>
    public const double PileHeld = 1e-3;

    /// <summary>If a margin keeps more than this share of its value at its sign change, it has jumped, as the load does at an edge.</summary>
    /// <remarks>Above: a jump is searched as a root, in vain. Below: a steep root counts as a jump.</remarks>
    public const double MarginJump = 1e-3;
}
