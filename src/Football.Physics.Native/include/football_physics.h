/* Football.Physics: the flight, bounce and roll of a football. Made of the exports by tests/regenerate.sh; not to be edited. */
#ifndef FOOTBALL_PHYSICS_H
#define FOOTBALL_PHYSICS_H

#include <stdint.h>

#if defined(_WIN32)
#define FOOTBALL_API __declspec(dllimport)
#else
#define FOOTBALL_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define FOOTBALL_ABI_VERSION 2
#define FOOTBALL_STATE_BYTES 216
#define FOOTBALL_SNAPSHOT_BYTES 228

/** The outcome of a call. */
typedef int32_t fp_status;
enum {
    /** The call succeeded. */
    FP_OK = 0,
    /** An argument is null or out of range, or a state was not created by the library; nothing has changed. */
    FP_ARGUMENT = 1,
    /** The text of a scene or of a request is rejected: invalid JSON, an unknown member, or a number out of range. */
    FP_SCENE = 2,
    /** The caller's buffer is too short. It contains the items that fit, and the call returns the total number. */
    FP_BUFFER = 3,
    /** The handle is not valid: it is null, was freed, or was never a handle of this kind. */
    FP_HANDLE = 4,
    /** The header does not match the library. */
    FP_ABI = 5,
    /** The library has a bug, or memory is exhausted; do not use the results of the call. */
    FP_INTERNAL = 6,
    /** The caller cancelled the call through its watch; nothing was written. */
    FP_CANCELLED = 7,
    /** Not used. It gives the constants the type int. */
    FP_STATUS_INT = -1
};

/** The motion of the ball, which selects the forces that act. */
typedef int32_t fp_motion;
enum {
    /** The ball is in the air, including between bounces. */
    FP_MOTION_AIRBORNE = 0,
    /** The ball is on the ground, and its contact point slips. */
    FP_MOTION_SLIDING = 1,
    /** The ball is on the ground and rolls without slip. */
    FP_MOTION_ROLLING = 2,
    /** The ball is at rest until the next kick. A step then costs almost nothing. */
    FP_MOTION_STOPPED = 3,
    /** The ball is caught between moving objects that leave it no room. */
    FP_MOTION_SQUEEZED = 4,
    /** Not used. It gives the constants the type int. */
    FP_MOTION_INT = -1
};

/** The kind of an event. If several events happen at one instant, an impact is reported before its consequences. */
typedef int32_t fp_event_kind;
enum {
    /** The ball hit the ground or an object. */
    FP_EVENT_IMPACT = 0,
    /** The ball stayed on the surface after an impact, and slides. */
    FP_EVENT_SLIDE = 1,
    /** The ball began to roll without slip. */
    FP_EVENT_ROLL = 2,
    /** The ball came to rest. */
    FP_EVENT_REST = 3,
    /** The ball hit a net. */
    FP_EVENT_NET = 4,
    /** A goal: the entire ball passed the goal line. */
    FP_EVENT_GOAL = 5,
    /** The ball left the surface that supported it, without an impact: over a crest, or lifted by a hit. */
    FP_EVENT_LEAVE = 6,
    /** Moving objects pinned the ball; the event reports one of these objects. An event without an object reports that the ball is free
        again. */
    FP_EVENT_SQUEEZED = 7,
    /** The ball entered a Zone. */
    FP_EVENT_ENTER_ZONE = 8,
    /** The ball left a Zone. */
    FP_EVENT_EXIT_ZONE = 9,
    /** Not used. It gives the constants the type int. */
    FP_EVENT_KIND_INT = -1
};

/** The event that ends a run early. */
typedef int32_t fp_stop;
enum {
    /** None: the run continues to its end time. */
    FP_STOP_TIME = 0,
    /** The first impact, just after its impulse. */
    FP_STOP_IMPACT = 1,
    /** The moment at which the ball comes to rest. */
    FP_STOP_REST = 2,
    /** Not used. It gives the constants the type int. */
    FP_STOP_INT = -1
};

/** The outcome of a search for a kick. */
typedef int32_t fp_aim_status;
enum {
    /** The kick passes within tolerance of the target, and of the waypoint if there is one. */
    FP_AIM_HIT = 0,
    /** No kick within the bounds hits the target; the result is the closest kick found. */
    FP_AIM_OUT_OF_REACH = 1,
    /** The search found no kick that hits, but nothing excludes one; the result is the closest kick found. */
    FP_AIM_NOT_CONVERGED = 2,
    /** The request has no direction: the target is at the ball's position. */
    FP_AIM_DEGENERATE = 3,
    /** The kick passes within tolerance of the target, but misses the waypoint: the allowed spins do not bend it enough. */
    FP_AIM_TARGET_ONLY = 4,
    /** The kick would hit, but an object blocks it; see BlockedBy. */
    FP_AIM_BLOCKED = 5,
    /** Not used. It gives the constants the type int. */
    FP_AIM_STATUS_INT = -1
};

/** The method that computed a spread. */
typedef int32_t fp_chance_method;
enum {
    /** The derivatives of one kick: the spread is small enough to be mapped linearly to the plane. */
    FP_CHANCE_DERIVATIVES = 0,
    /** The simulation of many random kicks. */
    FP_CHANCE_FLIGHTS = 1,
    /** Not used. It gives the constants the type int. */
    FP_CHANCE_METHOD_INT = -1
};

/** The verdicts on a fit. */
typedef int32_t fp_fit_verdict;
enum {
    /** chi^2 is consistent with the noise. */
    FP_FIT_AS_EXPECTED = 0,
    /** chi^2 is larger than noise produces once in 1000 tracks: the scene or the noise is wrong. */
    FP_FIT_POOR = 1,
    /** chi^2 is smaller than noise produces once in 1000 tracks: the actual noise is smaller than stated. */
    FP_FIT_NOISE_OVERESTIMATED = 2,
    /** Another launch, which bounces differently, fits about as well. */
    FP_FIT_AMBIGUOUS = 3,
    /** One of the other balls fits better. */
    FP_FIT_OTHER_BALL = 4,
    /** The search did not end at a minimum. */
    FP_FIT_NOT_CONVERGED = 5,
    /** Not used. It gives the constants the type int. */
    FP_FIT_VERDICT_INT = -1
};

/** The kinds of pieces of a match track. */
typedef int32_t fp_piece_kind;
enum {
    /** The ball flies; only the air acts on it. */
    FP_PIECE_FLIGHT = 0,
    /** The ball bounces on the ground. */
    FP_PIECE_IMPACT = 1,
    /** The ball rolls, slides, or hops lower than the track resolves. */
    FP_PIECE_GROUND = 2,
    /** A player or another object touches the ball: a kick, a header, a post. */
    FP_PIECE_TOUCH = 3,
    /** A gap, a track error, or a motion that no law of a free ball explains. */
    FP_PIECE_LOST = 4,
    /** Not used. It gives the constants the type int. */
    FP_PIECE_KIND_INT = -1
};

/** The parameters that a match fit can estimate. */
typedef int32_t fp_fit_parameter;
enum {
    /** The x component of the wind, m/s. */
    FP_PARAMETER_WIND_X = 0,
    /** The z component of the wind, m/s. */
    FP_PARAMETER_WIND_Z = 1,
    /** A factor of the drag. */
    FP_PARAMETER_DRAG = 2,
    /** The critical Reynolds number of the drag crisis. */
    FP_PARAMETER_CRISIS = 3,
    /** A factor of the Magnus force. */
    FP_PARAMETER_LIFT = 4,
    /** The height of the ground, m. */
    FP_PARAMETER_GROUND_HEIGHT = 5,
    /** The normal restitution of the ground. */
    FP_PARAMETER_RESTITUTION = 6,
    /** The increase of the restitution at grazing impacts. */
    FP_PARAMETER_RESTITUTION_RISE = 7,
    /** The friction of impacts; infinite if an impact always stops the slip. */
    FP_PARAMETER_FRICTION = 8,
    /** The friction of slides. */
    FP_PARAMETER_SLIDING_FRICTION = 9,
    /** The rolling resistance. */
    FP_PARAMETER_ROLLING_FRICTION = 10,
    /** The increase of the rolling resistance with the speed, s/m. */
    FP_PARAMETER_ROLLING_FRICTION_BY_SPEED = 11,
    /** Not used. It gives the constants the type int. */
    FP_FIT_PARAMETER_INT = -1
};

/** The answers of a match fit that are reliable to within their standard deviations. */
typedef int32_t fp_match_answers;
enum {
    /** None: only the positions, and about the speeds. */
    FP_GOOD_FOR_NONE = 0,
    /** The velocities of the flights. */
    FP_GOOD_FOR_LAUNCHES = 1,
    /** The spins of the flights. */
    FP_GOOD_FOR_SPINS = 2,
    /** The wind and the drag of the ball. */
    FP_GOOD_FOR_WIND_AND_DRAG = 4,
    /** The surface. */
    FP_GOOD_FOR_SURFACE = 8,
    /** Not used. It gives the constants the type int. */
    FP_MATCH_ANSWERS_INT = -1
};

/** Faults of a track that a match fit suspects or has removed. */
typedef int32_t fp_track_suspicions;
enum {
    /** None. */
    FP_SUSPICION_NONE = 0,
    /** The points or residuals are too large for a ball in metres and seconds: other units, times or columns. */
    FP_SUSPICION_UNITS = 1,
    /** The flights fall with another g: the clock, the frame rate or the scale of the heights is wrong. */
    FP_SUSPICION_SCALE = 2,
    /** The wind changes within the track: a half is turned, or the wind changed. */
    FP_SUSPICION_TURNED = 4,
    /** Another law of drag describes the flights better, but not to within the noise: another ball. */
    FP_SUSPICION_DRAG_LAW = 8,
    /** The residuals are far above the noise: the motion is not that of a free ball. */
    FP_SUSPICION_MISFIT = 16,
    /** Points lay on straight lines between others. They were left out. */
    FP_SUSPICION_LINES = 32,
    /** Points repeated the position of a moving ball. They were left out. */
    FP_SUSPICION_HELD = 64,
    /** Not used. It gives the constants the type int. */
    FP_TRACK_SUSPICIONS_INT = -1
};

/** A checked and compiled scene. It is immutable. Any number of threads may use it concurrently, even while one of them frees it. The
    pointer is a handle, not an address. */
typedef struct fp_scene fp_scene;

/** A match: a scene with bodies that move and obstacles that have a mass, and balls that are stepped together. Concurrent calls wait for
    each other. The pointer is a handle, not an address. */
typedef struct fp_match fp_match;

/** A filter that follows one ball. Concurrent calls wait for each other. The pointer is a handle, not an address. */
typedef struct fp_filter fp_filter;

/** The complete state of a ball, as plain bytes. Copy it to save, restore or roll back. Balls in the same state have the same bytes.
    fp_launch creates a state; all zero bytes are not a valid one. */
typedef struct { unsigned char bytes[FOOTBALL_STATE_BYTES]; } fp_state;

/** The visible state of a ball. Right-handed, y up, SI units. */
typedef struct {
    /** Position of the centre, m. */
    double position[3];
    /** Velocity, m/s. */
    double velocity[3];
    /** Angular velocity in the world frame, rad/s. */
    double spin[3];
    /** Orientation, body to world, a unit quaternion x, y, z, w. */
    double orientation[4];
    /** Time since the launch, s. */
    double time;
    /** The motion, one of fp_motion. */
    int32_t motion;
    /** 0. */
    int32_t reserved;
} fp_ball;

/** An event inside a step, at its exact time and position. */
typedef struct {
    /** The kind, one of fp_event_kind. */
    int32_t kind;
    /** The index in the scene of the object that the ball hits, touches or passes, or that supports it; -1 if there is none. fp_name writes
        its name. */
    int32_t thing;
    /** The time, s since the launch. */
    double time;
    /** The position of the ball's centre, m. */
    double position[3];
    /** Velocity just before, m/s. */
    double velocity_before[3];
    /** Velocity just after, m/s. */
    double velocity[3];
    /** Spin just before, rad/s. */
    double spin_before[3];
    /** Spin just after, rad/s. */
    double spin[3];
    /** The unit normal of the contact, from the object to the ball; zero without a contact. */
    double normal[3];
} fp_event;

/** The derivatives of the end of a run with respect to its launch. Matrices by rows: a row is a component at the end, a column one of the
    launch. */
typedef struct {
    /** The final position by the velocity of the launch, s. At an event, it is the position at the event, whose time changes too. */
    double position_by_velocity[9];
    /** The final position by the spin of the launch, m s/rad. */
    double position_by_spin[9];
    /** The final velocity, before the event, by the velocity of the launch. */
    double velocity_by_velocity[9];
    /** The final velocity, before the event, by the spin of the launch, m/rad. */
    double velocity_by_spin[9];
    /** The final time by the velocity of the launch, s^2/m; zero if the time ended the run. */
    double time_by_velocity[3];
    /** The final time by the spin of the launch, s^2/rad; zero if the time ended the run. */
    double time_by_spin[3];
} fp_derivatives;

/** A body that your game moves: a player, a foot, a head, a keeper's hand. */
typedef struct {
    /** Position, m; components within +-1e6. */
    double position[3];
    /** Orientation, body to world, a quaternion x, y, z, w of any length except 0. */
    double orientation[4];
    /** Velocity, m/s; at most 1000. A ball that hits a body with a mass changes it until you move the body again. */
    double velocity[3];
    /** Spin about the position, rad/s; at most 10 000. */
    double spin[3];
    /** The time of the position, s: the time of the balls before the step. The next step fails if they differ by more than 0.25 s. */
    double time;
    /** The impulse of the balls on the body in the last step, N s: the sum over its reported impacts. fp_match_move_bodies ignores it. */
    double impulse[3];
    /** 1 if the body is in play; 0 if it is withdrawn, so that no ball hits it. A body is at the origin and in play until you move it. */
    int32_t in_play;
    /** 0. */
    int32_t reserved;
} fp_body;

/** An event of one of the balls of a match. */
typedef struct {
    /** The event. fp_match_name writes the name of its object. */
    fp_event event;
    /** The index of the ball. */
    int32_t ball;
    /** The index of the other ball in an impact of two balls; otherwise -1. */
    int32_t other_ball;
    /** The index of the body that the ball hit or touches; otherwise -1. */
    int32_t body;
    /** 0. */
    int32_t reserved;
    /** The impulse on the ball in an impact, N s; zero for other events. The other object received the opposite impulse. */
    double impulse[3];
    /** The energy that a bumper added to the ball, J; otherwise 0. */
    double added_energy;
} fp_match_event;

/** A model of a player who runs to the ball. fp_player_default sets the numbers of a fit adult. */
typedef struct {
    /** Position, m; components within +-1e6. Its height is ignored. */
    double position[3];
    /** Velocity, m/s; speed at most 1000. Its vertical part is ignored. */
    double velocity[3];
    /** The reaction time, s; 0 or more. Until then, he keeps his velocity. */
    double reaction;
    /** The acceleration, m/s^2; above 0. */
    double acceleration;
    /** The top speed, m/s; above 0, at most 1000. */
    double speed;
    /** The maximum horizontal distance at which he can play the ball, m; 0 or more. */
    double reach;
    /** The minimum height of the ball's centre that he can play, m. */
    double minimum_height;
    /** The maximum height of the ball's centre that he can play, m: about 0.6 with the foot, 2.3 with the head, 2.7 with a keeper's hands. */
    double maximum_height;
} fp_player;

/** The player who reaches the ball first. */
typedef struct {
    /** The index of the player; -1 if nobody reaches the ball, and the other numbers are then 0. */
    int32_t player;
    /** 0. */
    int32_t reserved;
    /** The time at which he reaches the ball, s since its launch. */
    double time;
    /** His lead over the second player, s; infinite if no other player reaches the ball. */
    double margin;
    /** The position of the ball's centre then, m. */
    double position[3];
    /** The velocity of the ball then, m/s. */
    double velocity[3];
} fp_interception;

/** A time interval in which a player can reach the ball. */
typedef struct {
    /** The index of the player. */
    int32_t player;
    /** 0. */
    int32_t reserved;
    /** The start, s since the launch of the ball. */
    double from;
    /** The end, s since the launch of the ball. */
    double to;
    /** The position of the ball's centre at the start, m. */
    double position[3];
    /** The velocity of the ball at the start, m/s. */
    double velocity[3];
} fp_window;

/** How a player's kicks spread on the plane of a goal, and the probability that they score. */
typedef struct {
    /** The probability of a ball on target that the goalkeeper cannot reach, 0 ... 1. */
    double scores;
    /** The probability of a goal if nobody stops the ball, 0 ... 1, including goals in off the frame. */
    double on_target;
    /** The probability of a ball on target that the goalkeeper can reach in time, 0 ... 1; 0 without a goalkeeper. */
    double covered;
    /** The standard error of scores from the finite number of kicks; 0 if derivatives were used. */
    double standard_error;
    /** The share of the kicks that cross the plane of the goal, 0 ... 1; the following numbers refer to these kicks. */
    double crosses;
    /** The mean offset to the right of the goal's centre, m, as the goalkeeper sees it. */
    double aside;
    /** The mean height of the ball's centre above the goal line, m. */
    double height;
    /** The mean time of the crossing, s since the kick. */
    double time;
    /** The standard deviation of the offset, m. */
    double aside_deviation;
    /** The standard deviation of the height, m. */
    double height_deviation;
    /** The correlation of offset and height, -1 ... 1. */
    double correlation;
    /** The method, one of fp_chance_method. */
    int32_t method;
    /** The number of simulated kicks: the random kicks, or the test kicks if derivatives were used. */
    int32_t kicks;
} fp_goal_chance_result;

/** The launch estimated from a track, with its uncertainty. */
typedef struct {
    /** The time of the launch, s: that of the first point. */
    double time;
    /** The position at the launch, m. */
    double position[3];
    /** The velocity at the launch, m/s. */
    double velocity[3];
    /** The spin at the launch, rad/s. */
    double spin[3];
    /** The factors of drag, lift, restitution and friction relative to the scene; 1 if a factor was not estimated. */
    double factors[4];
    /** The standard error of each component of the position, m. */
    double position_deviation[3];
    /** The standard error of each component of the velocity, m/s. */
    double velocity_deviation[3];
    /** The standard error of each component of the spin, rad/s. */
    double spin_deviation[3];
    /** The standard errors of the factors; 0 if a factor was not estimated. */
    double factor_deviations[4];
    /** The spin of another launch that fits about as well, rad/s; zero unless has_other_spin is 1. */
    double other_spin[3];
    /** The sum of (observed - fitted)^2/noise^2 over all coordinates. */
    double chi_squared;
    /** The probability of an equal or larger chi_squared if the scene and the noise are correct. */
    double probability;
    /** The number of observed coordinates minus the number of parameters. */
    int32_t degrees_of_freedom;
    /** The number of search steps. */
    int32_t iterations;
    /** The verdict, one of fp_fit_verdict. */
    int32_t verdict;
    /** 1 if the search ended at a minimum; otherwise 0. */
    int32_t converged;
    /** Bit i is set if the track determines parameter i better than the prior: 0-2 position, 3-5 velocity, 6-8 spin, 9-12 factors. */
    int32_t identified;
    /** 1 if there is another spin; otherwise 0. */
    int32_t has_other_spin;
    /** The answers that are reliable to within their standard errors: the sum of values of fp_match_answers. */
    int32_t good_for;
    /** The suspected faults of the track: the sum of values of fp_track_suspicions. */
    int32_t suspicions;
} fp_fit_result;

/** A piece of a match track. The axes are those of the library: y is up. */
typedef struct {
    /** The kind, one of fp_piece_kind. */
    int32_t kind;
    /** The number of track points; 0 for an impact, a touch or a gap. */
    int32_t points;
    /** The start time, s; for an impact or a touch, its instant. */
    double start_time;
    /** The end time, s. */
    double end_time;
    /** The root mean square distance of the points from the fitted path, m; 0 without points. */
    double rms;
    /** The largest distance of a point from the fitted path, m. */
    double maximum_residual;
    /** The position of the ball's centre at the start, m. */
    double position[3];
    /** The velocity at the start, m/s; for an impact or a touch, just after it. */
    double velocity[3];
    /** The spin at the start, rad/s; for an impact or a touch, just after it. Zero if it is unknown. */
    double spin[3];
    /** The velocity just before an impact or a touch, m/s. */
    double velocity_before[3];
    /** The spin just before an impact or a touch, rad/s. */
    double spin_before[3];
    /** The standard deviation of each component of the velocity, m/s. */
    double velocity_deviation[3];
    /** The standard deviation of each component of the spin, rad/s. */
    double spin_deviation[3];
    /** The restitution of an impact; 0 unless has_restitution is 1. */
    double restitution;
    /** The ratio of the horizontal speeds after and before an impact; 0 for other pieces. */
    double speed_retained;
    /** 1 if the restitution is known; otherwise 0. */
    int32_t has_restitution;
    /** 0. */
    int32_t reserved;
} fp_piece;

/** The parameters that all pieces of a match track share. */
typedef struct {
    /** The parameters, in the order of fp_fit_parameter. A parameter that was not estimated has its value in the scene; a factor is then 1. */
    double values[12];
    /** The standard errors of the parameters; 0 if a parameter was not estimated. */
    double deviations[12];
    /** The root mean square of the residuals in flights of 0.3 s or longer, m. */
    double rms;
    /** The share of the points above 0.5 m that belong to such flights, 0 ... 1. */
    double covered;
    /** The standard deviation of the track's coordinates from one point to the next, m. */
    double noise;
    /** The mean speed of the rolls, m/s; 0 if the ball never rolls untouched. */
    double rolling_speed;
    /** The standard deviation of the rolling resistance at that speed. */
    double rolling_deviation;
    /** Bit i is set if parameter i was estimated. */
    int32_t estimated;
    /** The number of flights of 0.3 s or longer. */
    int32_t flights;
    /** The number of impacts from which the surface was estimated. */
    int32_t impacts;
    /** The number of intervals in which the ball slid or rolled untouched. */
    int32_t windows;
    /** The answers that are reliable to within their standard errors: the sum of values of fp_match_answers. */
    int32_t good_for;
    /** The suspected faults of the track: the sum of values of fp_track_suspicions. */
    int32_t suspicions;
} fp_fit_match_result;

/** The outputs of an impact, for sound, haptics and looks. The simulation does not depend on them. */
typedef struct {
    /** The impulse on the ball, N s. The object received the opposite impulse. */
    double impulse[3];
    /** The impulse along the normal, N s; at least 0. */
    double normal_impulse;
    /** The impulse of friction, N s; at least 0. */
    double tangential_impulse;
    /** The speed of the ball's contact point along the surface just before, m/s. */
    double slip_before;
    /** The same just after, m/s. */
    double slip_after;
    /** The duration of a real impact, s. */
    double contact_time;
    /** The largest compression of the ball, m. */
    double compression;
    /** The largest normal force, N. */
    double peak_force;
    /** The kinetic energy lost, J, relative to the surface; negative if a bumper adds energy. */
    double energy_lost;
    /** 1 if friction held the contact; 0 if the ball slipped. */
    int32_t grips;
    /** 0. */
    int32_t reserved;
} fp_impact_result;

/** The settings of a filter; fp_filter_default returns the defaults. */
typedef struct {
    /** The standard deviation of a measured coordinate, m; above 0, at most 100. */
    double noise;
    /** The standard deviation of a pixel coordinate, pixels; above 0, at most 1000. */
    double pixel_noise;
    /** The standard deviation of each component of the velocity just after a kick, m/s; above 0, at most 300. */
    double kick_velocity;
    /** The standard deviation of each component of the spin just after a kick, rad/s; above 0, at most 1000. */
    double kick_spin;
    /** The expected number of kicks per second, 1e-6 ... 100. */
    double kicks_per_second;
    /** The expected share of wrong points, 1e-6 ... 0.5. */
    double outlier_share;
    /** The time over which the motion is fitted to the points themselves, s; 0.2 ... 20. */
    double window;
    /** The longest gap that the filter bridges, s; 0.05 ... 20. */
    double maximum_gap;
} fp_filter_settings;

/** The estimate of a filter at the time of its last point. */
typedef struct {
    /** The time of the last point, s. */
    double time;
    /** The position, m. */
    double position[3];
    /** The velocity, m/s. */
    double velocity[3];
    /** The spin, rad/s. */
    double spin[3];
    /** The standard deviations of a component of position, velocity and spin: root mean squares of the three axes. */
    double deviations[3];
    /** The covariance of position, velocity and spin, row by row. */
    double covariance[81];
    /** The time of a kick within the last 0.5 s; NaN without one. */
    double kick_time;
    /** The standard deviation of that time, s. */
    double kick_deviation;
    /** The probability of that kick, 0 ... 1. */
    double kick_probability;
    /** The motion, an fp_motion. */
    int32_t motion;
    /** 1 if the filter believes in the kick. */
    int32_t has_kick;
    /** 1 if the last point does not fit the motion. */
    int32_t is_outlier;
    /** 1 if the ball seems to move with a player. */
    int32_t is_held;
} fp_estimate;

/** Watches a long call: shows its progress, and cancels it. Set bytes to sizeof(fp_watch) and the other members to 0 before the call. */
typedef struct {
    /** sizeof(fp_watch). The call compares it with the size in the library. */
    int32_t bytes;
    /** 0. Another thread or a signal handler sets it to 1 to cancel the call, which then returns FP_CANCELLED soon. If it is 1 before, the
        call returns at once. */
    int32_t cancel;
    /** The progress, 0 ... 1. The call writes it; another thread may read it during the call. */
    double progress;
} fp_watch;

/** The forces on a ball with which its next step begins, for arrows and overlays. A force that does not act is zero. World frame. */
typedef struct {
    /** The weight, N. */
    double weight[3];
    /** The buoyancy in the air, N. */
    double buoyancy[3];
    /** The drag, against the motion through the air, N. */
    double drag[3];
    /** The Magnus force, across spin and motion through the air, N. */
    double magnus[3];
    /** The knuckle force of the seams, N; it acts only in flight. */
    double knuckle[3];
    /** The sum of the custom forces, N. A scene in JSON has none, so it is zero. */
    double custom[3];
    /** The sum of the forces of all nets that the ball is in, N. */
    double nets[3];
    /** The sum of the loads of all contacts, along their normals, N. */
    double load[3];
    /** The sum of the friction of all contacts, N; it includes rolling resistance, and the force that holds a ball at rest. */
    double friction[3];
    /** The sum of all forces, N. */
    double sum[3];
    /** The acceleration with which the next step begins, m/s^2; sum divided by the mass, to within rounding. */
    double acceleration[3];
    /** 1 if there are forces. 0, and all vectors zero, if the step begins with an impact or solves the contacts by impulses, or if the
        contacts of a ball at rest do not determine their forces. */
    int32_t determined;
    /** 0. */
    int32_t reserved;
} fp_forces_result;

/** The forces of one contact on a ball. */
typedef struct {
    /** The index of the object in the scene. fp_name writes its name. */
    int32_t thing;
    /** 0. */
    int32_t reserved;
    /** The contact point, m. */
    double point[3];
    /** The unit normal of the surface, towards the ball. */
    double normal[3];
    /** The force along the normal, N. */
    double load[3];
    /** The force along the surface, N. */
    double friction[3];
} fp_contact_force;

/** Checks that the header matches the library. Call it once, as FOOTBALL_CHECK_ABI().
    version: FOOTBALL_ABI_VERSION.
    state_bytes: sizeof(fp_state).
    ball_bytes: sizeof(fp_ball).
    event_bytes: sizeof(fp_event).
    Returns FP_OK, or FP_ABI. */
FOOTBALL_API fp_status fp_check_abi(int32_t version, int32_t state_bytes, int32_t ball_bytes, int32_t event_bytes);

/** Checks the sizes of the structures that fp_check_abi does not check. FOOTBALL_CHECK_ABI() calls both.
    body_bytes: sizeof(fp_body).
    match_event_bytes: sizeof(fp_match_event).
    player_bytes: sizeof(fp_player).
    interception_bytes: sizeof(fp_interception).
    window_bytes: sizeof(fp_window).
    goal_chance_bytes: sizeof(fp_goal_chance_result).
    fit_bytes: sizeof(fp_fit_result).
    piece_bytes: sizeof(fp_piece).
    fit_match_bytes: sizeof(fp_fit_match_result).
    impact_bytes: sizeof(fp_impact_result).
    filter_bytes: sizeof(fp_filter_settings).
    estimate_bytes: sizeof(fp_estimate).
    forces_bytes: sizeof(fp_forces_result).
    contact_bytes: sizeof(fp_contact_force).
    Returns FP_OK, or FP_ABI. */
FOOTBALL_API fp_status fp_check_structs(int32_t body_bytes, int32_t match_event_bytes, int32_t player_bytes, int32_t interception_bytes, int32_t window_bytes, int32_t goal_chance_bytes, int32_t fit_bytes, int32_t piece_bytes, int32_t fit_match_bytes, int32_t impact_bytes, int32_t filter_bytes, int32_t estimate_bytes, int32_t forces_bytes, int32_t contact_bytes);

/** Checks that the structures of another language match those of the library: a check without a macro, for generated bindings.
    version: FOOTBALL_ABI_VERSION.
    sizes: The sizes of the structures in bytes, in the order of the header, from fp_state on.
    n: Their number. At least 1, and at most the number of the structures.
    Returns FP_OK, FP_ARGUMENT if sizes is null or n is not 1 ... the number of structures, or FP_ABI. */
FOOTBALL_API fp_status fp_check_sizes(int32_t version, const int32_t* sizes, int32_t n);

/** Returns the version of the library, for example "0.1.0".
    Returns a text in UTF-8, valid while the library is loaded. */
FOOTBALL_API const char* fp_version(void);

/** Returns the message of the last call of this thread that failed: field, value and range. A call that succeeds does not change it.
    Returns a text in UTF-8, valid until the thread's next call that fails; "" if no call has failed. */
FOOTBALL_API const char* fp_last_error(void);

/** Reads, checks and compiles a scene.
    json: An object in UTF-8 with members of a scenario: profile, ball, air, gravity, forces, ground, goals, obstacles, nets, zones,
      dials, solver; {} for the default scene.
    json_bytes: Its length in bytes, without a terminating zero; at most 1 048 576.
    scene: Receives the handle; null if the call fails.
    Returns FP_OK, FP_SCENE if the text is rejected, or FP_ARGUMENT. */
FOOTBALL_API fp_status fp_scene_create(const char* json, int64_t json_bytes, fp_scene** scene);

/** Frees a scene. A running call of another thread finishes normally.
    scene: The scene; null or a freed handle is rejected.
    Returns FP_OK, or FP_HANDLE. */
FOOTBALL_API fp_status fp_scene_free(fp_scene* scene);

/** Writes the name of the object of an event: "ground", "left post", or the name of an obstacle.
    scene: The scene.
    thing: The member thing of the event; the name of -1 is "".
    name: Receives the name in UTF-8, with a terminating zero.
    capacity: The number of bytes at name, at least 1. If the name is longer, it is truncated, and the call returns FP_BUFFER.
    Returns FP_OK, FP_BUFFER, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_name(const fp_scene* scene, int32_t thing, char* name, int32_t capacity);

/** Computes the energy that an impact with a bumper added to the ball. A bumper is an obstacle with a restitution above 1 or a minimum exit
    speed.
    scene: The scene.
    event: An event of a step in that scene.
    Returns the energy, J; 0 for any other event, or if a pointer is rejected. */
FOOTBALL_API double fp_added_energy(const fp_scene* scene, const fp_event* event);

/** Returns a 64-bit hash of a state. It equals Snapshot.Hash in C#, and is the same on every machine.
    state: The state.
    Returns the hash; 0 if the state is null. */
FOOTBALL_API uint64_t fp_hash(const fp_state* state);

/** Writes the default settings of a filter.
    settings: Receives the settings.
    Returns FP_OK, or FP_ARGUMENT. */
FOOTBALL_API fp_status fp_filter_default(fp_filter_settings* settings);

/** Creates a filter that follows one ball.
    scene: The scene.
    settings: The settings; null for the defaults.
    filter: Receives the handle; null if the call fails. Free it with fp_filter_free.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_filter_create(const fp_scene* scene, const fp_filter_settings* settings, fp_filter** filter);

/** Frees a filter.
    filter: The filter; null or a freed handle is rejected.
    Returns FP_OK, or FP_HANDLE. */
FOOTBALL_API fp_status fp_filter_free(fp_filter* filter);

/** Forgets all points.
    filter: The filter.
    Returns FP_OK, or FP_HANDLE. */
FOOTBALL_API fp_status fp_filter_reset(fp_filter* filter);

/** Includes measured positions, and writes the estimate after each.
    filter: The filter.
    times: n times, s, within 1e10.
    positions: n rows x, y, z of the ball's centre, m; y is up. A row with y = NaN has no height; a row with x = NaN is a gap.
    noise: n standard deviations of the coordinates, m; null for that of the settings.
    n: The number of points, 0 ... 1 000 000.
    estimates: Receives n estimates; null to skip them. A gap before the first point has zeros.
    Returns FP_OK; FP_ARGUMENT if a point is rejected (the points before it count), or FP_HANDLE. */
FOOTBALL_API fp_status fp_filter_update(fp_filter* filter, const double* times, const double* positions, const double* noise, int64_t n, fp_estimate* estimates);

/** Includes a pixel of a camera.
    filter: The filter.
    time: The time, s.
    camera: The 3 x 4 matrix of the camera, row by row: (a, b, w) = matrix (x, y, z, 1), u = a/w, v = b/w; w is positive in front of the
      camera.
    u: The pixel to the right.
    v: The pixel downwards.
    noise: The standard deviation of each coordinate, pixels; 0 for that of the settings.
    estimate: Receives the estimate; null to skip it.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_filter_update_pixel(fp_filter* filter, double time, const double camera[12], double u, double v, double noise, fp_estimate* estimate);

/** Predicts the path from the estimate, with its standard deviation.
    filter: The filter.
    seconds: The duration, s; above 0, at most 60.
    every: The interval of the rows, s; above 0.
    path: Receives rows (t, x, y, z, deviation), the first at the last point; the deviation is that of a component, m.
    rows: The number of rows that fit, 0 or more.
    written: Receives the number of rows written; null to skip it.
    Returns FP_OK, FP_ARGUMENT (also before the first point) or FP_HANDLE. */
FOOTBALL_API fp_status fp_filter_look_ahead(fp_filter* filter, double seconds, double every, double* path, int64_t rows, int64_t* written);

/** Saves the whole filter as bytes.
    filter: The filter.
    bytes: Receives the bytes; null if capacity is 0.
    capacity: The number of bytes that fit, 0 or more.
    count: Receives the number of bytes, even if they do not fit.
    Returns FP_OK, FP_BUFFER if capacity is too small (nothing is written), FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_filter_save(const fp_filter* filter, char* bytes, int64_t capacity, int64_t* count);

/** Restores a filter from the bytes of fp_filter_save. It then gives the same bits as the saved one.
    filter: A filter with the same scene and settings.
    bytes: The bytes.
    count: Their number.
    Returns FP_OK; FP_ARGUMENT if these are not the bytes of such a filter (nothing changes), or FP_HANDLE. */
FOOTBALL_API fp_status fp_filter_restore(fp_filter* filter, const char* bytes, int64_t count);

/** Estimates the launch of a ball, and on request factors of the scene, from its tracked positions.
    scene: The scene.
    times: n times, s, in order.
    positions: n rows x, y, z of the ball's centre, m; y is up.
    noise: n standard deviations of the coordinates, m; above 0; null for 0.02 m.
    n: The number of points, 4 ... 1 000 000.
    request_json: An object in UTF-8 with the members of a scenario's fit, except noise: also, spin, spinDeviation, factorDeviation,
      timeStep; {} for none.
    bytes: Its length in bytes; at most 1 048 576.
    out: Receives the result.
    Returns FP_OK, whatever the verdict; FP_SCENE if the text is rejected, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_fit(const fp_scene* scene, const double* times, const double* positions, const double* noise, int64_t n, const char* request_json, int64_t bytes, fp_fit_result* out);

/** The same as fp_fit, with progress and cancellation.
    scene: The scene.
    times: As for fp_fit, like all parameters up to out.
    positions: n rows x, y, z, m.
    noise: n standard deviations, m; null for 0.02 m.
    n: The number of points.
    request_json: The request.
    bytes: Its length in bytes.
    out: Receives the result.
    watch: Shows the progress, and cancels the call; null for neither.
    Returns As fp_fit; FP_CANCELLED if watch cancelled the call. */
FOOTBALL_API fp_status fp_fit_watched(const fp_scene* scene, const double* times, const double* positions, const double* noise, int64_t n, const char* request_json, int64_t bytes, fp_fit_result* out, fp_watch* watch);

/** Divides the track of a match into flights, impacts, touches and ground contact, and estimates the wind, the ball and the surface.
    scene: The scene, with the values known before the fit.
    times: n times, s, in order.
    positions: n rows x, y, z of the ball's centre, m; y is up.
    noise: n minimum standard deviations of the coordinates, m; null for 0.02 m.
    n: The number of points, 8 ... 1 000 000.
    request_json: An object in UTF-8: free, a list of the quantities to estimate (wind, drag, crisis, lift, surface, height; default wind,
      drag, surface, height); windDeviation, factorDeviation, crisisDeviation, spinDeviation; {} for the default.
    bytes: Its length in bytes; at most 1 048 576.
    pieces: Receives the pieces, in order of time; null if capacity is 0.
    capacity: The number of pieces that fit, 0 or more.
    count: Receives the number of pieces, including those that do not fit; null to skip it.
    out: Receives the parameters; null to skip them.
    fitted: Receives the handle of a new scene with the parameters. Free it with fp_scene_free. Null to skip it.
    Returns FP_OK; FP_BUFFER if there are more pieces than capacity (all other results are written); FP_SCENE if the text is rejected,
    FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_fit_match(const fp_scene* scene, const double* times, const double* positions, const double* noise, int64_t n, const char* request_json, int64_t bytes, fp_piece* pieces, int32_t capacity, int32_t* count, fp_fit_match_result* out, fp_scene** fitted);

/** The same as fp_fit_match, with progress and cancellation.
    scene: The scene, with the values known before the fit.
    times: As for fp_fit_match, like all parameters up to fitted.
    positions: n rows x, y, z, m.
    noise: n minimum standard deviations, m; null for 0.02 m.
    n: The number of points.
    request_json: The request.
    bytes: Its length in bytes.
    pieces: Receives the pieces; null if capacity is 0.
    capacity: The number of pieces that fit.
    count: Receives the number of pieces; null to skip it.
    out: Receives the parameters; null to skip them.
    fitted: Receives the handle of a new scene; null to skip it.
    watch: Shows the progress, and cancels the call; null for neither.
    Returns As fp_fit_match; FP_CANCELLED if watch cancelled the call, and fitted then receives null. */
FOOTBALL_API fp_status fp_fit_match_watched(const fp_scene* scene, const double* times, const double* positions, const double* noise, int64_t n, const char* request_json, int64_t bytes, fp_piece* pieces, int32_t capacity, int32_t* count, fp_fit_match_result* out, fp_scene** fitted, fp_watch* watch);

/** Computes the forces with which the next step of a ball begins, for arrows and overlays. Nothing changes. It costs about as much as a
    step, and allocates.
    scene: The scene.
    state: The ball; unchanged. For a ball of a match, use fp_match_state first; bodies and other balls then do not count.
    dt: The length of the next step, s; above 0, at most 1e12. It matters only for a ball that is about to stop.
    out: Receives the forces.
    contacts: Receives the forces of each contact; null to skip them. In flight there are none.
    capacity: The number of contacts that fit, 0 or more.
    count: Receives the number of contacts, including those that do not fit; null to skip it.
    Returns FP_OK; FP_BUFFER if contacts or count is given, and there are more contacts than capacity: the first ones are written.
    FP_ARGUMENT or FP_HANDLE, with nothing written. */
FOOTBALL_API fp_status fp_forces(const fp_scene* scene, const fp_state* state, double dt, fp_forces_result* out, fp_contact_force* contacts, int32_t capacity, int32_t* count);

/** Computes the outputs of an impact with a stationary surface: impulses, slip, duration, compression, peak force, energy.
    scene: The scene.
    event: An impact of a ball in this scene.
    out: Receives the outputs.
    Returns FP_OK, FP_HANDLE, or FP_ARGUMENT: the event is not an impact, or its object moves or has a mass. For the event of a match, use
    fp_match_impact. */
FOOTBALL_API fp_status fp_impact(const fp_scene* scene, const fp_event* event, fp_impact_result* out);

/** Sets a player to a fit adult at the origin: reaction 0.2 s, acceleration 6 m/s^2, speed 8 m/s, reach 0.6 m, heights 0 ... 2.3 m.
    player: Receives the player.
    Returns FP_OK or FP_ARGUMENT. */
FOOTBALL_API fp_status fp_player_default(fp_player* player);

/** Finds the player who reaches the ball first. If two players arrive within a nanosecond, returns the lower index.
    scene: The scene.
    state: The ball; unchanged. Its path is predicted until it rests; it then stays at rest.
    seconds: The length of the prediction, s; above 0, at most 3600.
    players: The players at the current time.
    n: The number of players; 0 ... 10 000.
    out: Receives the first player.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_intercept(const fp_scene* scene, const fp_state* state, double seconds, const fp_player* players, int32_t n, fp_interception* out);

/** Finds all time intervals in which each player can reach the ball.
    scene: The scene.
    state: The ball, as for fp_intercept.
    seconds: The length of the prediction, s; above 0, at most 3600.
    players: The players at the current time.
    n: The number of players; 0 ... 10 000.
    windows: Receives the intervals, sorted by player, then by time; null if capacity is 0.
    capacity: The number of intervals that fit, 0 or more.
    count: Receives the number of intervals, including those that do not fit; null to skip it.
    Returns FP_OK; FP_BUFFER if there are more intervals than capacity (the first ones are written); FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_intercept_windows(const fp_scene* scene, const fp_state* state, double seconds, const fp_player* players, int32_t n, fp_window* windows, int32_t capacity, int32_t* count);

/** Computes the probability that a player's kick scores: by derivatives if they are accurate, otherwise by simulating random kicks.
    scene: The scene. Its solver settings are not used.
    request_json: An object in UTF-8: position, velocity, spin; orientation, a quaternion x, y, z, w, on which only the knuckle force
      depends; spread with speedPercent, elevationDegrees, azimuthDegrees, spinPercent and their correlations; goal, the index of a goal of
      the scene; keeper, a player; kicks, the number of kicks to simulate, 2 ... 100 000 000, 2 to 6 microseconds each; seed;
      alwaysSimulate. Only position and velocity are required.
    bytes: Its length in bytes; at most 1 048 576.
    out: Receives the result.
    Returns FP_OK; FP_SCENE if the text is rejected, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_goal_chance(const fp_scene* scene, const char* request_json, int64_t bytes, fp_goal_chance_result* out);

/** The same as fp_goal_chance, with progress and cancellation.
    scene: The scene.
    request_json: The request, as for fp_goal_chance.
    bytes: Its length in bytes.
    out: Receives the result.
    watch: Shows the progress, and cancels the call; null for neither.
    Returns As fp_goal_chance; FP_CANCELLED if watch cancelled the call. */
FOOTBALL_API fp_status fp_goal_chance_watched(const fp_scene* scene, const char* request_json, int64_t bytes, fp_goal_chance_result* out, fp_watch* watch);

/** Creates a match at time 0, with its balls at rest on the ground, side by side along x from the origin.
    json: An object in UTF-8 with the members of a scene, as for fp_scene_create, and bodies. Obstacles and bodies can have a mass. balls,
      a list of objects with a ball each, gives each ball its own size, mass and drag; ballContact is the material of their contacts.
    json_bytes: Its length in bytes, without a terminating zero; at most 1 048 576.
    balls: The number of balls; 1 ... 10 000. If the JSON has a list balls, the number must equal its length.
    dt: The length of a step, s; above 0, at most 1e12.
    match: Receives the handle; null if the call fails.
    Returns FP_OK, FP_SCENE if the text is rejected, or FP_ARGUMENT. */
FOOTBALL_API fp_status fp_match_create(const char* json, int64_t json_bytes, int32_t balls, double dt, fp_match** match);

/** Frees a match. A running call of another thread finishes normally.
    match: The match; null or a freed handle is rejected.
    Returns FP_OK, or FP_HANDLE. */
FOOTBALL_API fp_status fp_match_free(fp_match* match);

/** Writes the name of the object of an event in a match: "ground", "left post", or the name of a body or an obstacle.
    match: The match.
    thing: The member thing of the event; the name of -1 is "".
    name: Receives the name in UTF-8, with a terminating zero.
    capacity: The number of bytes at name, at least 1. If the name is longer, it is truncated, and the call returns FP_BUFFER.
    Returns FP_OK, FP_BUFFER, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_match_name(const fp_match* match, int32_t thing, char* name, int32_t capacity);

/** Kicks a ball at the start of the next step: sets its velocity and spin. A second kick of this ball before the step replaces the first.
    match: The match.
    ball: The index of the ball, from 0.
    velocity: Velocity, m/s; speed at most 1000.
    spin: Spin, rad/s, world frame; at most 10 000.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_match_kick(fp_match* match, int32_t ball, const double velocity[3], const double spin[3]);

/** Moves bodies for the next step, in which they keep their velocity and spin. Bodies that you do not move continue their motion. Allocates
    nothing.
    match: The match.
    first: The index of the first body, from 0, in the order of the JSON.
    n: The number of bodies, 0 or more.
    bodies: The n bodies.
    Returns FP_OK; FP_ARGUMENT or FP_HANDLE, with no body moved. */
FOOTBALL_API fp_status fp_match_move_bodies(fp_match* match, int32_t first, int32_t n, const fp_body* bodies);

/** Takes a step: applies the restarts, then the kicks, advances all balls, and returns the events. Allocates nothing, except if a recording
    grows.
    match: The match.
    events: Receives the events of all balls, ordered by time, then by ball; null to skip them.
    capacity: The number of events that fit, 0 or more. A step stores at most 1 024 events: the first 1 008 and the last 16.
    count: Receives the number of events, including those that do not fit or are not stored; null to skip it.
    Returns FP_OK; FP_BUFFER if events or count is given, and there are more events than capacity or than a step stores. The step is then
    complete, and the first events are written, at most capacity or 1 024. FP_ARGUMENT or FP_HANDLE, with nothing changed. */
FOOTBALL_API fp_status fp_match_step(fp_match* match, fp_match_event* events, int32_t capacity, int32_t* count);

/** Computes the outputs of an impact in the last step: impulses, slip, duration, compression, peak force, energy.
    match: The match.
    event: The index of the event in the last step, from 0, as fp_match_step writes them; below 1 024.
    out: Receives the outputs.
    Returns FP_OK, FP_HANDLE, or FP_ARGUMENT: the last step has no such event, or the event is not an impact. */
FOOTBALL_API fp_status fp_match_impact(const fp_match* match, int32_t event, fp_impact_result* out);

/** Reads balls.
    match: The match.
    first: The index of the first ball, from 0.
    n: The number of balls, 0 or more.
    balls: Receives the n balls. Their time counts from the start of the match.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_match_read_balls(const fp_match* match, int32_t first, int32_t n, fp_ball* balls);

/** Reads bodies, with the impulses of the last step.
    match: The match.
    first: The index of the first body, from 0, in the order of the JSON.
    n: The number of bodies, 0 or more.
    bodies: Receives the n bodies. Position and orientation apply at the body's time; since then it has moved with its velocity and spin.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_match_read_bodies(const fp_match* match, int32_t first, int32_t n, fp_body* bodies);

/** Copies a ball into a scene, with the same position and motion, for fp_look_ahead, fp_intercept and fp_aim. The scene determines what the
    ball touches.
    match: The match; unchanged.
    ball: The index of the ball, from 0.
    scene: The scene, for example that of the match without its bodies.
    out: Receives the state.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_match_state(const fp_match* match, int32_t ball, const fp_scene* scene, fp_state* out);

/** Returns a 64-bit hash of all balls. It equals Snapshot.Hash in C#, and is the same on every machine.
    match: The match.
    Returns the hash; 0 if the handle is invalid. */
FOOTBALL_API uint64_t fp_match_hash(const fp_match* match);

/** Returns the number of steps since the start of the match.
    match: The match.
    Returns the number; -1 if the handle is invalid. */
FOOTBALL_API int64_t fp_match_tick(const fp_match* match);

/** Launches a ball. If it overlaps the ground, it is raised vertically onto the surface. A ball on the ground without speed stays at rest.
    scene: The scene.
    position: Position of the centre, m; components within +-1e6.
    velocity: Velocity, m/s; speed at most 1000.
    spin: Spin, rad/s, world frame; at most 10 000.
    out: Receives the state.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_launch(const fp_scene* scene, const double position[3], const double velocity[3], const double spin[3], fp_state* out);

/** Kicks a ball: sets its velocity and spin, and keeps its position, time and orientation.
    scene: The scene.
    state: The ball.
    velocity: Velocity, m/s; speed at most 1000.
    spin: Spin, rad/s, world frame; at most 10 000.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_kick(const fp_scene* scene, fp_state* state, const double velocity[3], const double spin[3]);

/** Advances a ball by a time, and returns the events in between. Allocates nothing.
    scene: The scene.
    state: The ball.
    dt: Time to advance by, s; 0 ... 1e12. It is one step of the integrator, which splits it only at events.
    events: Receives the events, in order of time; null to skip them.
    capacity: The number of events that fit, 0 or more. A step stores at most 1 024 events: the first 1 008 and the last 16.
    count: Receives the number of events, including those that do not fit or are not stored; null to skip it.
    Returns FP_OK; FP_BUFFER if events or count is given, and there are more events than capacity or than a step stores. The step is then
    complete, and the first events are written, at most capacity or 1 024. FP_ARGUMENT or FP_HANDLE, with the ball unchanged. */
FOOTBALL_API fp_status fp_step(const fp_scene* scene, fp_state* state, double dt, fp_event* events, int32_t capacity, int32_t* count);

/** Reads position, velocity, spin, orientation, time and motion of a ball.
    scene: The scene.
    state: The ball.
    out: Receives them.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_read(const fp_scene* scene, const fp_state* state, fp_ball* out);

/** Advances many balls by the same number of steps, without reporting events. To use several threads, pass each thread a part of the balls.
    Allocates nothing.
    scene: The scene.
    states: The balls.
    n: The number of balls, 0 or more.
    dt: Length of a step, s; 0 ... 1e12.
    steps: The number of steps, 0 or more.
    Returns FP_OK; FP_ARGUMENT or FP_HANDLE, with the balls unchanged. */
FOOTBALL_API fp_status fp_step_many(const fp_scene* scene, fp_state* states, int64_t n, double dt, int32_t steps);

/** Launches many balls, as fp_launch does.
    scene: The scene.
    states: Receives the states.
    n: The number of balls, 0 or more.
    mask: n bytes: 0 skips a ball and leaves its state unchanged, even if uninitialised; null launches all.
    position: n rows x, y, z, m.
    velocity: n rows x, y, z, m/s.
    spin: n rows x, y, z, rad/s.
    Returns FP_OK; FP_ARGUMENT or FP_HANDLE, with no state written. */
FOOTBALL_API fp_status fp_launch_many(const fp_scene* scene, fp_state* states, int64_t n, const unsigned char* mask, const double* position, const double* velocity, const double* spin);

/** Kicks many balls, as fp_kick does.
    scene: The scene.
    states: The balls.
    n: The number of balls, 0 or more.
    mask: n bytes: 0 leaves a ball unchanged; null kicks all.
    velocity: n rows x, y, z, m/s.
    spin: n rows x, y, z, rad/s.
    Returns FP_OK; FP_ARGUMENT or FP_HANDLE, with no ball kicked. */
FOOTBALL_API fp_status fp_kick_many(const fp_scene* scene, fp_state* states, int64_t n, const unsigned char* mask, const double* velocity, const double* spin);

/** Reads position, velocity, spin and motion of many balls, one row per ball.
    scene: The scene.
    states: The balls.
    n: The number of balls, 0 or more.
    position: Receives n rows x, y, z, m; null to skip them.
    velocity: Receives n rows x, y, z, m/s; null to skip them.
    spin: Receives n rows x, y, z, rad/s; null to skip them.
    motion: Receives n values of fp_motion; null to skip them.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_read_many(const fp_scene* scene, const fp_state* states, int64_t n, double* position, double* velocity, double* spin, int32_t* motion);

/** Reads the clocks of many balls.
    scene: The scene.
    states: The balls.
    n: The number of balls, 0 or more.
    time: Receives n times since the launch, s.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_time_many(const fp_scene* scene, const fp_state* states, int64_t n, double* time);

/** Advances many balls in equal steps, each until its own event (such as landing or rest) or until a time.
    scene: The scene.
    states: The balls. A ball whose run ends with its event has the state just after that event.
    n: The number of balls, 0 or more.
    dt: Length of a step, s; above 0, at most 1e12, at least 1e-12 of seconds. The last step is shortened.
    seconds: The maximum duration, s; above 0, at most 1e12.
    stop_at: The event that ends a run, one of fp_stop.
    ended: Receives n numbers: 1 if the event ended the run, 0 if the time did; null to skip them.
    Returns FP_OK; FP_ARGUMENT or FP_HANDLE, with the balls unchanged. */
FOOTBALL_API fp_status fp_run_many(const fp_scene* scene, fp_state* states, int64_t n, double dt, double seconds, int32_t stop_at, int32_t* ended);

/** Writes a state as bytes to send or store, little-endian on every machine, with a checksum. Snapshot.Write in C# writes the same bytes.
    state: The ball.
    bytes: Receives the bytes.
    Returns FP_OK or FP_ARGUMENT. */
FOOTBALL_API fp_status fp_snapshot_write(const fp_state* state, unsigned char bytes[FOOTBALL_SNAPSHOT_BYTES]);

/** Reads the bytes that fp_snapshot_write, or Snapshot.Write in C#, wrote.
    bytes: The bytes.
    out: Receives the state.
    Returns FP_OK, or FP_ARGUMENT if the bytes are not the state of a ball, or are corrupt. */
FOOTBALL_API fp_status fp_snapshot_read(const unsigned char bytes[FOOTBALL_SNAPSHOT_BYTES], fp_state* out);

/** Places a ball: sets its position, velocity, spin and orientation, and keeps its time. Without velocity and spin it is at rest, or falls.
    scene: The scene.
    state: The ball.
    position: Position of the centre, m; components within +-1e6. A ball that overlaps the ground is raised onto it.
    velocity: Velocity, m/s; speed at most 1000; null: zero.
    spin: Spin, rad/s, world frame; at most 10 000; null: zero.
    orientation: A quaternion x, y, z, w of any length except 0; null: the identity.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_place(const fp_scene* scene, fp_state* state, const double position[3], const double velocity[3], const double spin[3], const double orientation[4]);

/** Moves a ball to a position at once, sets its velocity and spin to zero, and discards its kick and restart of the next step. A recording
    ends; fp_match_queue_place continues it.
    match: The match.
    ball: The index of the ball, from 0.
    position: Position of the centre, m; components within +-1e6. A ball that overlaps the ground is raised onto it.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_match_place(fp_match* match, int32_t ball, const double position[3]);

/** Restarts a ball at the start of the next step, before its kick: sets its position, velocity, spin and orientation. The clock and a
    recording continue, and no kick is discarded. A second restart of this ball before the step replaces the first.
    match: The match.
    ball: The index of the ball, from 0.
    position: Position of the centre, m; components within +-1e6. A ball that overlaps the ground is raised onto it.
    velocity: Velocity, m/s; speed at most 1000; null: zero.
    spin: Spin, rad/s, world frame; at most 10 000; null: zero.
    orientation: A quaternion x, y, z, w of any length except 0; null: the identity.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_match_queue_place(fp_match* match, int32_t ball, const double position[3], const double velocity[3], const double spin[3], const double orientation[4]);

/** Predicts the path of a ball: runs the simulation on a copy. Allocates nothing.
    scene: The scene.
    state: The ball; unchanged.
    seconds: The length of the prediction, s; 0 ... 3600.
    every: Time between rows, s; 1e-6 ... 3600. The step is every, divided by the smallest integer that makes it at most 0.08 s. If every
      is your game's step, the rows are bit-identical to its later steps.
    path: Receives rows t, x, y, z, in s since the launch and m: the first now, the others every so many seconds. A ball at rest has rows
      too.
    rows: The number of rows that fit, 0 or more.
    written: Receives the number of rows written; null to skip it.
    Returns FP_OK, FP_BUFFER if there are more rows, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_look_ahead(const fp_scene* scene, const fp_state* state, double seconds, double every, double* path, int64_t rows, int64_t* written);

/** Finds a kick that reaches a target.
    scene: The scene.
    request_json: An object in UTF-8 with the members of a scenario's aim: from, target, speed, and the optional ones.
    bytes: Its length in bytes; at most 1 048 576.
    velocity: Receives the velocity of the best kick found, m/s, whatever the verdict.
    spin: Receives the spin of that kick, rad/s, world frame.
    miss: Receives the distance by which that kick misses the target, m; null to skip it.
    aim_status: Receives the verdict, one of fp_aim_status; null to skip it. fp_aim_reason explains it.
    Returns FP_OK, whatever the verdict; FP_SCENE if the text is rejected, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_aim(const fp_scene* scene, const char* request_json, int64_t bytes, double velocity[3], double spin[3], double* miss, int32_t* aim_status);

/** Returns the reason for the verdict of this thread's last fp_aim: the bound that excludes every kick, the undefined quantity, or the
    nearest miss. A failed fp_aim does not change it.
    Returns a text in UTF-8, valid until the thread's next call of fp_aim_reason; "" after a hit, or if there was no fp_aim. */
FOOTBALL_API const char* fp_aim_reason(void);

/** Runs a ball to an event or a time, and computes the derivatives of its final position with respect to the launch, in one run.
    scene: The scene.
    state: The ball. Its current motion is the launch. Receives the state at the end, as in fp_run_many.
    dt: Length of a step, s; above 0, at most 1e12, at least 1e-12 of seconds. The last step is shortened.
    seconds: The maximum duration, s; above 0, at most 1e12.
    stop_at: The event that ends the run, one of fp_stop.
    out: Receives the derivatives.
    ended: Receives 1 if the event ended the run, 0 if the time did; null to skip it.
    Returns FP_OK; FP_ARGUMENT or FP_HANDLE, with the ball unchanged. */
FOOTBALL_API fp_status fp_derivatives_run(const fp_scene* scene, fp_state* state, double dt, double seconds, int32_t stop_at, fp_derivatives* out, int32_t* ended);

/** Saves a match between two steps: balls, kicks, restarts, bodies and movable obstacles. After fp_match_restore, the steps are
    bit-identical. Allocates nothing.
    match: The match.
    bytes: Receives the bytes, which are the same on every machine; null if capacity is 0.
    capacity: The number of bytes that fit, 0 or more.
    written: Receives the total number of bytes, which is fixed for a match; null to skip it.
    Returns FP_OK; FP_BUFFER if capacity is too small, with nothing written at bytes; FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_match_save(const fp_match* match, unsigned char* bytes, int64_t capacity, int64_t* written);

/** Restores a match from the bytes of fp_match_save, also in another process or on another machine. Allocates nothing.
    match: The saved match, or one that was created with the same arguments by the same version of the library.
    bytes: The bytes.
    n: The number of bytes.
    Returns FP_OK; FP_ARGUMENT if the bytes are corrupt, or belong to another match or to an earlier version of the library, or FP_HANDLE,
    with nothing changed. */
FOOTBALL_API fp_status fp_match_restore(fp_match* match, const unsigned char* bytes, int64_t n);

/** Starts a recording at this tick. It ends when you place a ball, or restore a state that it does not contain.
    match: The match.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_match_record(fp_match* match);

/** Returns the recording so far as bytes, which Recording.FromBytes also reads in C#. The recording continues.
    match: The match.
    bytes: Receives the bytes; null if capacity is 0.
    capacity: The number of bytes that fit, 0 or more.
    written: Receives the total number of bytes; null to skip it.
    Returns FP_OK; FP_BUFFER if capacity is too small, with nothing written at bytes; FP_ARGUMENT if no recording was started, or FP_HANDLE. */
FOOTBALL_API fp_status fp_match_recording(const fp_match* match, unsigned char* bytes, int64_t capacity, int64_t* written);

/** Creates a match at the start of a recording. Its steps repeat the recorded kicks, restarts and the motions of the bodies; you can only
    step, seek and read it.
    json: The scene, as for fp_match_create.
    json_bytes: Its length in bytes; at most 1 048 576.
    recording: The recording: bytes from fp_match_recording, or from Recording.ToBytes in C# for a BallGroup.
    n: The number of bytes of the recording.
    match: Receives the handle; null if the call fails.
    Returns FP_OK, FP_SCENE if the text is rejected, or FP_ARGUMENT if the recording is corrupt or belongs to another scene. */
FOOTBALL_API fp_status fp_match_replay(const char* json, int64_t json_bytes, const unsigned char* recording, int64_t n, fp_match** match);

/** Moves a replay to a tick, forwards or backwards, by at most 63 steps from a recorded state.
    match: A match from fp_match_replay.
    tick: The tick, from the first to the last of the recording.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_match_seek(fp_match* match, int64_t tick);

/** Replays a recording from its start, and compares the hash of the balls after every step. The replay then is at the tick that differs, or
    at the end.
    match: A match from fp_match_replay.
    tick: Receives the first tick at which the balls differ; -1 if all are bit-identical.
    Returns FP_OK, FP_ARGUMENT or FP_HANDLE. */
FOOTBALL_API fp_status fp_match_verify(fp_match* match, int64_t* tick);

/** Computes the force and torque of the air on many bodies that another engine moves: drag, Magnus force, spin decay and wind, as in a
    flight of the library. Gravity and buoyancy are not included. Ground and obstacles are ignored. Allocates nothing.
    scene: The scene; its ball gives mass, radius and moment of inertia.
    n: The number of bodies, 0 or more.
    position: n rows x, y, z, m; components within +-1e6. Only a wind that varies by position depends on it.
    velocity: n rows x, y, z, m/s; speed at most 1000.
    spin: n rows x, y, z, rad/s; at most 10 000.
    time: Time, s; 0 ... 1e12. Only a wind that varies in time depends on it.
    air_distance: n distances flown through the air since the kick, m, for the knuckle force; null for 0.
    orientation: n rows x, y, z, w, of any length except 0, for the knuckle force; null for the identity.
    force: Receives n rows x, y, z, N.
    torque: Receives n rows x, y, z, N m; null to skip them.
    Returns FP_OK; FP_ARGUMENT or FP_HANDLE, with nothing written. */
FOOTBALL_API fp_status fp_air_many(const fp_scene* scene, int64_t n, const double* position, const double* velocity, const double* spin, double time, const double* air_distance, const double* orientation, double* force, double* torque);

/** Checks that this header matches the library. Other languages call fp_check_sizes. */
#define FOOTBALL_CHECK_ABI() (fp_check_abi(FOOTBALL_ABI_VERSION, (int32_t)sizeof(fp_state), (int32_t)sizeof(fp_ball), (int32_t)sizeof(fp_event)) != FP_OK ? (fp_status)FP_ABI : fp_check_structs((int32_t)sizeof(fp_body), (int32_t)sizeof(fp_match_event), (int32_t)sizeof(fp_player), (int32_t)sizeof(fp_interception), (int32_t)sizeof(fp_window), (int32_t)sizeof(fp_goal_chance_result), (int32_t)sizeof(fp_fit_result), (int32_t)sizeof(fp_piece), (int32_t)sizeof(fp_fit_match_result), (int32_t)sizeof(fp_impact_result), (int32_t)sizeof(fp_filter_settings), (int32_t)sizeof(fp_estimate), (int32_t)sizeof(fp_forces_result), (int32_t)sizeof(fp_contact_force)))

/* The former names of these macros, for one more version. <math.h> also begins names with FP_. */
#define FP_ABI_VERSION FOOTBALL_ABI_VERSION
#define FP_SNAPSHOT_BYTES FOOTBALL_SNAPSHOT_BYTES
#define FP_CHECK_ABI() FOOTBALL_CHECK_ABI()

#ifdef __cplusplus
}
#endif

#endif
