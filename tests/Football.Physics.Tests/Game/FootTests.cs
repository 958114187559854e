using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Game;

/// <summary>A strike of a foot, forward against values worked out with another calculator, and back.</summary>
public sealed class FootTests
{
    private static readonly BallProperties s_ball = BallProperties.Tunnel;

    [Theory]
    [InlineData(0, 32.618, 0, 0)]
    [InlineData(0.02, 32.118, 7.50, 22.74)]
    [InlineData(0.04, 30.567, 15.06, 45.47)]
    [InlineData(0.06, 27.792, 22.69, 68.21)]
    [InlineData(0.08, 23.360, 30.07, 90.94)]
    public void A_foot_that_passes_the_centre_gives_speed_and_spin(double offset, double speed, double angle, double spin)
    {
        // The line of the foot is along x, to the right of the ball's centre seen from the foot.
        double sine = offset / s_ball.Radius;
        var normal = new Vector3d(Math.Sqrt(1 - (sine * sine)), 0, -sine);
        FootStrike strike = new Foot().Strike(s_ball, Vector3d.Zero, Vector3d.Zero, new Vector3d(25, 0, 0), normal);
        Assert.Equal(speed, strike.Velocity.Length, 5.1e-4);
        Assert.Equal(angle, Math.Abs(Math.Atan2(strike.Velocity.Z, strike.Velocity.X)) * 180 / Math.PI, 5.1e-3);
        Assert.Equal(spin, strike.Spin.Length, 5.1e-3);
        Assert.Equal(0, strike.Velocity.Y, 1e-12);
        Assert.True(strike.Velocity.Z <= 0 && strike.Spin.Y >= 0);
    }

    [Fact]
    public void Momentum_is_kept_and_energy_never_grows()
    {
        var random = new Shots(41);
        for (int i = 0; i < 500; i++)
        {
            var foot = new Foot
            {
                Mass = random.Uniform(0.5, 4),
                Restitution = random.Uniform(0, 1),
                TangentialRestitution = random.Uniform(0, 1),
                Friction = random.Uniform(0, 2),
            };
            Vector3d v = random.Uniform(0, 20) * random.Direction();
            Vector3d w = random.Uniform(0, 60) * random.Direction();
            Vector3d u = random.Uniform(0, 30) * random.Direction();
            Vector3d n = random.Direction();
            FootStrike strike = foot.Strike(s_ball, v, w, u, random.Uniform(0.5, 3) * n);
            Assert.InRange(Vector3d.Distance(strike.Normal, n), 0, 1e-15);
            Vector3d lost = (s_ball.Mass * (v - strike.Velocity)) + (foot.Mass * (u - strike.FootVelocityAfter));
            Assert.InRange(lost.Length, 0, 1e-12);
            double Energy(Vector3d ball, Vector3d spin, Vector3d other) => 0.5 * ((s_ball.Mass * ball.LengthSquared) + (s_ball.MomentOfInertia * spin.LengthSquared) + (foot.Mass * other.LengthSquared));
            double before = Energy(v, w, u);
            Assert.True(Energy(strike.Velocity, strike.Spin, strike.FootVelocityAfter) <= before * (1 + 1e-13));
        }
    }

    /// <summary>
    /// Coulomb's law along the impulse: dv = dJ/m, dω = −(r/I) n × dJ, dU = −dJ/M in small shares of the normal impulse, with friction against the slip of the moment, up to
    /// Newton's end of the approach.
    /// </summary>
    [Fact]
    public void A_strike_is_the_integral_of_its_impulse_over_the_whole_range()
    {
        const int Shares = 1000;
        var random = new Shots(43);
        int gripped = 0;
        for (int i = 0; i < 300; i++)
        {
            var foot = new Foot { Mass = random.Uniform(0.5, 5), Restitution = random.Uniform(0, 1), Friction = random.Uniform(0, 1.5) };
            (Vector3d v, Vector3d w, Vector3d u) = (random.Uniform(0, 20) * random.Direction(), random.Uniform(0, 100) * random.Direction(), random.Uniform(0, 30) * random.Direction());
            Vector3d n = random.Direction();
            FootStrike strike = foot.Strike(s_ball, v, w, u, n);
            double approach = Vector3d.Dot(u - v, n);
            double share = approach > 0 ? (1 + foot.Restitution) * approach / ((1 / s_ball.Mass) + (1 / foot.Mass)) / Shares : 0;
            bool grips = false;
            for (int k = 0; k < Shares; k++)
            {
                Vector3d slip = v - u - (Vector3d.Dot(v - u, n) * n) + (s_ball.Radius * Vector3d.Cross(n, w));
                double stop = slip.Length / (((1 + (1 / s_ball.InertiaFactor)) / s_ball.Mass) + (1 / foot.Mass));
                grips = stop <= foot.Friction * share;
                Vector3d impulse = (share * n) - (slip.Length > 0 ? Math.Min(foot.Friction * share, stop) / slip.Length * slip : Vector3d.Zero);
                v += impulse / s_ball.Mass;
                w -= s_ball.Radius / s_ball.MomentOfInertia * Vector3d.Cross(n, impulse);
                u -= impulse / foot.Mass;
            }

            Assert.InRange(Vector3d.Distance(v, strike.Velocity), 0, 1e-9);
            Assert.InRange(Vector3d.Distance(w, strike.Spin), 0, 1e-7);
            Assert.InRange(Vector3d.Distance(u, strike.FootVelocityAfter), 0, 1e-9);
            gripped += grips && share > 0 ? 1 : 0;
        }

        Assert.InRange(gripped, 20, 200);
    }

    [Fact]
    public void A_foot_that_goes_away_changes_nothing()
    {
        FootStrike strike = new Foot().Strike(s_ball, new Vector3d(5, 0, 0), new Vector3d(0, 9, 0), new Vector3d(3, 0, 0), new Vector3d(1, 0, 0));
        Assert.Equal((new Vector3d(5, 0, 0), new Vector3d(0, 9, 0), new Vector3d(3, 0, 0)), (strike.Velocity, strike.Spin, strike.FootVelocityAfter));
    }

    [Fact]
    public void The_strike_for_a_kick_gives_that_kick()
    {
        var random = new Shots(42);
        int limited = 0;
        for (int i = 0; i < 500; i++)
        {
            var foot = new Foot { TangentialRestitution = random.Uniform(0, 0.5) };
            Vector3d v = random.Uniform(0, 10) * random.Direction();
            Vector3d w = random.Uniform(0, 30) * random.Direction();
            Vector3d wantedVelocity = random.Uniform(15, 32) * random.Direction();
            Vector3d wantedSpin = random.Uniform(0, 300) * random.Direction();
            FootStrike strike = foot.StrikeFor(s_ball, v, w, wantedVelocity, wantedSpin);
            FootStrike played = foot.Strike(s_ball, v, w, strike.FootVelocity, strike.Normal);
            Assert.InRange(Vector3d.Distance(played.Velocity, wantedVelocity), 0, 1e-9);
            Assert.InRange(Vector3d.Distance(played.Velocity, strike.Velocity), 0, 1e-9);
            Assert.InRange(Vector3d.Distance(played.Spin, strike.Spin), 0, 1e-8);
            Assert.InRange(Vector3d.Distance(played.FootVelocityAfter, strike.FootVelocityAfter), 0, 1e-9);

            Vector3d direction = (wantedVelocity - v) / (wantedVelocity - v).Length;
            Vector3d missing = wantedSpin - strike.Spin - (strike.SpinAlongImpulse * direction);
            Assert.Equal(strike.EnoughFriction, missing.Length < 1e-8);
            Assert.Equal(0, Vector3d.Dot(missing, direction), 1e-8);
            limited += strike.EnoughFriction ? 0 : 1;
        }

        Assert.InRange(limited, 20, 480);
    }

    [Fact]
    public void A_leg_that_is_too_slow_kicks_a_resting_ball_the_same_way_as_fast_as_it_can()
    {
        var random = new Shots(43);
        for (int i = 0; i < 200; i++)
        {
            Vector3d wantedVelocity = random.Uniform(15, 40) * random.Direction();
            Vector3d wantedSpin = random.Uniform(0, 100) * random.Direction();
            FootStrike wanted = new Foot().StrikeFor(s_ball, Vector3d.Zero, Vector3d.Zero, wantedVelocity, wantedSpin);
            double fastest = random.Uniform(0.1, 0.99) * wanted.FootVelocity.Length;
            FootStrike strike = new Foot { MaximumSpeed = fastest }.StrikeFor(s_ball, Vector3d.Zero, Vector3d.Zero, wantedVelocity, wantedSpin);
            double share = fastest / wanted.FootVelocity.Length;
            Assert.False(strike.FastEnough);
            Assert.InRange(fastest - strike.FootVelocity.Length, 0, 1e-9);
            Assert.InRange(Vector3d.Distance(strike.Velocity, share * wantedVelocity), 0, 1e-9);
            Assert.InRange(Vector3d.Distance(strike.Spin, share * wanted.Spin), 0, 1e-7);
            Assert.InRange(Vector3d.Distance(strike.Normal, wanted.Normal), 0, 1e-9);

            // With as much as it takes nothing changes.
            FootStrike same = new Foot { MaximumSpeed = wanted.FootVelocity.Length }.StrikeFor(s_ball, Vector3d.Zero, Vector3d.Zero, wantedVelocity, wantedSpin);
            Assert.True(same.FastEnough);
            Assert.Equal(wanted.FootVelocity, same.FootVelocity);
        }
    }

    [Fact]
    public void A_leg_that_is_too_slow_plays_a_moving_ball_the_wanted_way_where_it_can()
    {
        var random = new Shots(44);
        Foot[] foots = [new Foot { MaximumSpeed = 2 }, new Foot { MaximumSpeed = 12 }];
        int slower = 0;
        int swings = 0;
        for (int i = 0; i < 500; i++)
        {
            Vector3d v = random.Uniform(0, 25) * random.Direction();
            Vector3d w = random.Uniform(0, 30) * random.Direction();
            Vector3d wanted = random.Uniform(5, 32) * random.Direction();
            Foot foot = foots[i % 2];
            FootStrike strike = foot.StrikeFor(s_ball, v, w, wanted, random.Uniform(0, 60) * random.Direction());
            FootStrike played = foot.Strike(s_ball, v, w, strike.FootVelocity, strike.Normal);
            Assert.InRange(strike.FootVelocity.Length, 0, foot.MaximumSpeed + 1e-9);
            Assert.InRange(Vector3d.Distance(played.Velocity, strike.Velocity), 0, 1e-9);
            bool straight = Vector3d.Cross(strike.Velocity, wanted).Length < 1e-6 * wanted.Length;
            Assert.InRange(strike.Velocity.Length, 0, straight ? wanted.Length + 1e-9 : 100);
            Assert.True(strike.FastEnough ? Vector3d.Distance(strike.Velocity, wanted) < 1e-9 : !straight || strike.Velocity.Length < wanted.Length);
            slower += !strike.FastEnough && straight ? 1 : 0;
            swings += !straight ? 1 : 0;
        }

        Assert.InRange(slower, 50, 450);
        Assert.InRange(swings, 20, 300);
    }

    /// <summary>The ball's velocity is a fraction of the wanted one, zero, or opposite, and the ball spins: that fraction of the kick needs no impulse.</summary>
    [Fact]
    public void A_leg_that_is_too_slow_plays_a_ball_that_moves_in_the_wanted_direction()
    {
        var random = new Shots(45);
        int straight = 0;
        for (int i = 0; i < 600; i++)
        {
            Vector3d wanted = random.Uniform(5, 32) * random.Direction();
            Vector3d v = ((i % 7) - 3) / 4.0 * wanted;
            Vector3d w = random.Uniform(0, 60) * random.Direction();
            Vector3d spin = random.Uniform(0, 60) * random.Direction();
            var foot = new Foot { MaximumSpeed = i % 3 == 0 ? random.Uniform(0.05, 0.5) : random.Uniform(0.5, 10) };
            FootStrike strike = foot.StrikeFor(s_ball, v, w, wanted, spin);
            Assert.InRange(strike.FootVelocity.Length, 0, foot.MaximumSpeed + 1e-9);
            FootStrike played = foot.Strike(s_ball, v, w, strike.FootVelocity, strike.Normal);
            Assert.InRange(Vector3d.Distance(played.Velocity, strike.Velocity), 0, 1e-9);
            Assert.InRange(Vector3d.Distance(played.Spin, strike.Spin), 0, 1e-7);
            bool isStraight = Vector3d.Cross(strike.Velocity, wanted).Length < 1e-6 * wanted.Length && Vector3d.Dot(strike.Velocity, wanted) > 0;
            straight += isStraight ? 1 : 0;

            // The result is at least as fast as each sixteenth of the kick that a foot of this speed can give.
            for (int share = 1; share < 16 && !strike.FastEnough; share++)
            {
                Vector3d part = share / 16.0 * wanted;
                bool isFast = part != v && new Foot().StrikeFor(s_ball, v, w, part, w + (share / 16.0 * (spin - w))).FootVelocity.Length <= foot.MaximumSpeed;
                Assert.True(!isFast || (isStraight && strike.Velocity.Length >= part.Length - 1e-9), $"{i}: {share} sixteenths");
            }
        }

        Assert.InRange(straight, 50, 550);
    }

    [Fact]
    public void A_ball_at_rest_that_spins_leaves_in_the_wanted_direction_also_after_a_touch_of_a_very_slow_foot()
    {
        var random = new Shots(46);
        for (int i = 0; i < 100; i++)
        {
            Vector3d wanted = random.Uniform(20, 32) * random.Direction();
            Vector3d w = random.Uniform(2, 5) * random.Direction();
            FootStrike strike = new Foot { MaximumSpeed = 1 }.StrikeFor(s_ball, Vector3d.Zero, w, wanted, Vector3d.Zero);
            Assert.Equal(1, strike.FootVelocity.Length, 1e-9);
            Assert.InRange(strike.Velocity.Length, 0.2, 2);
            Assert.InRange(Vector3d.Distance(strike.Velocity.Length / wanted.Length * wanted, strike.Velocity), 0, 1e-9);
        }
    }

    [Fact]
    public void The_spin_that_friction_just_allows_is_reached()
    {
        var random = new Shots(48);
        var foot = new Foot { Friction = 0.4 };
        int limited = 0;
        for (int i = 0; i < 200; i++)
        {
            Vector3d v = random.Uniform(0, 10) * random.Direction();
            Vector3d w = random.Uniform(0, 30) * random.Direction();
            Vector3d wanted = random.Uniform(15, 32) * random.Direction();
            FootStrike most = foot.StrikeFor(s_ball, v, w, wanted, random.Uniform(500, 900) * random.Direction());
            FootStrike same = foot.StrikeFor(s_ball, v, w, wanted, most.Spin);
            Assert.True(same.EnoughFriction);
            Assert.InRange(Vector3d.Distance(most.Spin, same.Spin), 0, 1e-9);
            limited += most.EnoughFriction ? 0 : 1;
        }

        Assert.InRange(limited, 100, 200);
    }

    /// <summary>Without friction, the impulse is along the normal, through the centre.</summary>
    [Fact]
    public void A_foot_without_friction_gives_any_velocity_and_keeps_the_spin()
    {
        var random = new Shots(47);
        var foot = new Foot { Friction = 0 };
        for (int i = 0; i < 100; i++)
        {
            Vector3d v = random.Uniform(0, 10) * random.Direction();
            Vector3d w = random.Uniform(1, 30) * random.Direction();
            Vector3d wanted = random.Uniform(15, 32) * random.Direction();
            FootStrike same = foot.StrikeFor(s_ball, v, w, wanted, w);
            Assert.True(same.EnoughFriction);
            FootStrike other = foot.StrikeFor(s_ball, v, w, wanted, Vector3d.Zero);
            Assert.False(other.EnoughFriction);
            foreach (FootStrike strike in new[] { same, other })
            {
                Vector3d n = (wanted - v) / (wanted - v).Length;
                Assert.InRange(Vector3d.Distance(strike.Normal, n), 0, 1e-12);
                Assert.InRange(Vector3d.Distance(strike.Spin, w), 0, 1e-9);
                double approach = (wanted - v).Length * (1 + (s_ball.Mass / foot.Mass)) / (1 + foot.Restitution);
                Assert.Equal(Vector3d.Dot(v, n) + approach, Vector3d.Dot(strike.FootVelocity, n), 1e-9);
            }
        }
    }

    [Fact]
    public void Numbers_out_of_range_are_refused()
    {
        Refused("foot.mass is 0", () => Strike(new Foot { Mass = 0 }));
        Refused("foot.restitution is 1.2", () => Strike(new Foot { Restitution = 1.2 }));
        Refused("foot.tangentialRestitution is -1", () => Strike(new Foot { TangentialRestitution = -1 }));
        Refused("foot.maximumSpeed is 0", () => StrikeFor(new Foot { MaximumSpeed = 0 }));
        Refused("foot.mass is 0", () => StrikeFor(new Foot { Mass = 0 }));
        Refused("foot.friction is NaN", () => Strike(new Foot { Friction = double.NaN }));
        Refused("foot.normal is (0, 0, 0)", () => Strike(new Foot(), normal: 0));
        Refused("foot.normal is (Infinity, 0, 0)", () => Strike(new Foot(), normal: double.PositiveInfinity));
        Refused("foot.velocity is (1001", () => Strike(new Foot(), foot: 1001));
        Refused("ball.velocity is (1001", () => Strike(new Foot(), velocity: 1001));
        Refused("ball.spin is (0, 10001", () => Strike(new Foot(), spin: 10_001));
        Refused("ball.spin is (0, 10001", () => StrikeFor(new Foot(), spin: 10_001));
        Refused("kick.velocity is (3, 0, 0)", () => StrikeFor(new Foot(), velocity: 3));
        Refused("kick.velocity is (1001", () => StrikeFor(new Foot(), wanted: 1001));
        Refused("kick.spin is (0, 10001", () => StrikeFor(new Foot(), wantedSpin: 10_001));
        Refused("ball.mass is -1", () => Strike(new Foot(), ball: s_ball with { Mass = -1 }));
        Assert.Throws<ArgumentNullException>(() => new Foot().Strike(null!, Vector3d.Zero, Vector3d.Zero, Vector3d.Up, Vector3d.Up));

        static FootStrike Strike(Foot hits, double velocity = 0, double spin = 0, double foot = 10, double normal = 1, BallProperties? ball = null) =>
            hits.Strike(ball ?? s_ball, new Vector3d(velocity, 0, 0), new Vector3d(0, spin, 0), new Vector3d(foot, 0, 0), new Vector3d(normal, 0, 0));
        static FootStrike StrikeFor(Foot hits, double velocity = 0, double spin = 0, double wanted = 3, double wantedSpin = 0) =>
            hits.StrikeFor(s_ball, new Vector3d(velocity, 0, 0), new Vector3d(0, spin, 0), new Vector3d(wanted, 0, 0), new Vector3d(0, wantedSpin, 0));
        static void Refused(string message, Func<FootStrike> strike) =>
            Assert.Contains(message, Assert.Throws<ArgumentOutOfRangeException>(() => strike()).Message, StringComparison.Ordinal);
    }
}
