using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Replay;

/// <summary>The pose of a goalkeeper at a time, for drawings.</summary>
/// <param name="Time">The time, in s.</param>
/// <param name="Body">The position of his centre, in m, and his orientation.</param>
internal readonly record struct KeeperPose(double Time, BallPose Body)
{
    /// <summary>The distances from his centre to his feet, and from his feet to his shoulders and to the hands above his head, in m.</summary>
    private const double Half = 0.98;
    private const double Shoulders = 1.42;
    private const double Hands = 2.1;

    /// <summary>The movement below which a pose is not stored again, in m.</summary>
    private const double Still = 1e-4;

    /// <summary>The lean at which his hands are above his head: 1 − cos of the angle.</summary>
    private const double Stretched = 0.12;

    /// <summary>The time between stored poses, in s.</summary>
    private const double Step = 0.04;

    private static readonly Vector3d s_ahead = new(0, 0, 1);

    /// <summary>His axis, from the feet to the head.</summary>
    private Vector3d Up => Body.Orientation.Rotate(Vector3d.Up);

    /// <summary>The point between his feet, in m.</summary>
    public Vector3d Feet => Body.Position - (Half * Up);

    /// <summary>The feet, shoulders, hands and facing direction. He holds his hands in front of him when he stands, and above his head in a dive.</summary>
    public Vector3d[] Skeleton
    {
        get
        {
            Vector3d up = Up;
            Vector3d feet = Feet;
            double stretched = Math.Min(1, (1 - up.Y) / Stretched);
            Vector3d ready = feet + (1.15 * up) + (0.35 * s_ahead);
            return [feet, feet + (Shoulders * up), Vector3d.Lerp(ready, feet + (Hands * up), stretched), s_ahead];
        }
    }

    /// <summary>His body as a shape of a drawing.</summary>
    public SceneShape Shape
    {
        get
        {
            var rod = (FootballPhysics.Shapes.CapsuleShape)Engines.KeeperDive.Kind.Shape;
            return new SceneShape("keeper", SceneShapeKind.Obstacle)
            {
                Lines = [[Body.Position + Body.Orientation.Rotate(rod.From), Body.Position + Body.Orientation.Rotate(rod.To)]],
                Radius = rod.Radius,
            };
        }
    }

    /// <summary>Returns the poses of a keeper before the steps of a shot, without repetitions.</summary>
    /// <param name="scenario">A shot that moves the keeper.</param>
    /// <param name="keeper">The keeper.</param>
    public static IReadOnlyList<KeeperPose> Of(Scenario scenario, Engines.KeeperDive keeper)
    {
        var all = new List<KeeperPose>();
        ScenarioRun.Play(scenario with
        {
            BeforeStep = ball =>
            {
                scenario.BeforeStep!(ball);
                all.Add(new KeeperPose(ball.Time, keeper.BodyPose));
            },
        });
        List<KeeperPose> kept = [all[0]];
        for (int i = 1; i < all.Count; i++)
        {
            bool moved = (all[i].Body.Position - kept[^1].Body.Position).Length > Still;
            if (moved && all[i - 1].Time > kept[^1].Time && (all[i - 1].Body.Position - kept[^1].Body.Position).Length <= Still)
            {
                kept.Add(all[i - 1]);
            }

            if (moved && (all[i].Time - kept[^1].Time >= Step - 1e-9 || i + 1 == all.Count || (all[i + 1].Body.Position - all[i].Body.Position).Length <= Still))
            {
                kept.Add(all[i]);
            }
        }

        return kept;
    }

    /// <summary>Returns the last pose at or before a time.</summary>
    public static KeeperPose At(IReadOnlyList<KeeperPose> poses, double time) => poses.Last(pose => pose.Time <= Math.Max(time, poses[0].Time));
}
