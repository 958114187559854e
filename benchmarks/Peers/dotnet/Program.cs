using System.Runtime.CompilerServices;
using FootballPhysics;
using FootballPhysics.Netcode;
using FootballPhysics.Peers;

// Peers football|minimal SHOTS
string version = typeof(Ball).Assembly.GetName().Version!.ToString(3);
if (args[0] == "football")
{
    new Harness<BallState>(o => new FootballWorld(o), args[1]).Run("Football.Physics", version, ccd: true, rolls: true, Snapshot.Size, "ball");
}
else
{
    new Harness<MinimalState>(o => new MinimalWorld(o), args[1]).Run("Minimal rigid body", "", ccd: false, rolls: false, Unsafe.SizeOf<MinimalState>(), "by hand");
}
