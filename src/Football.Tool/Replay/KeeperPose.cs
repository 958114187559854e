using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Replay;

/// <summary>The pose of a goalkeeper at a time, as pictures draw him.</summary>
/// <param name="Time">The time, s.</param>
/// <param name="Body">The position of his centre, m, and his orientation.</param>
internal readonly record struct KeeperPose(double Time, BallPose Body)
{
    /// <summary>From his centre to his feet, and from his feet to his shoulders and to his hands above the head, m.</summary>
    private const double Half = 0.98;
    private const double Shoulders = 1.42;
    private const double Hands = 2.1;

    /// <summary>Movement below which a pose is not stored again, m.</summary>
    private const double Still = 1e-4;

    /// <summary>How far he leans when his hands are above his head: 1 − cos of the angle.</summary>
    private const double Stretched = 0.12;

    /// <summary>The time between stored poses, s.</summary>
    private const double Step = 0.04;

    private static readonly Vector3d s_ahead = new(0, 0, 1);

    /// <summary>His axis, from the feet to the head.</summary>
    private Vector3d Up => Body.Orientation.Rotate(Vector3d.Up);

    /// <summary>The point between his feet, m.</summary>
    public Vector3d Feet => Body.Position - (Half * Up);

    /// <summary>Feet, shoulders, hands and the direction that he faces: the hands are in front of him while he stands, and above his head in a dive.</summary>
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

    /// <summary>His body as an obstacle of a drawing.</summary>
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

    /// <summary>The poses in which a keeper is before the steps of a shot; poses that repeat are left out.</summary>
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

    /// <summary>The last of the poses up to a time.</summary>
    public static KeeperPose At(IReadOnlyList<KeeperPose> poses, double time) => poses.Last(pose => pose.Time <= Math.Max(time, poses[0].Time));
}
