using System.Reflection;
using System.Runtime.InteropServices;
using FootballPhysics.Netcode;
using FootballPhysics.Shims;
using FootballPhysics.Unity;
using Unity.Entities;
using Unity.NetCode;

namespace FootballPhysics.Package.Tests;

/// <summary>The recipes of docs/netcode.md, played by two peers: at least 1 000 messages are up to 20 ticks late, out of their order, and then both peers have the same ball.</summary>
[Collection(EngineTests.Statics)]
public sealed class RecipeTests : IDisposable
{
    private const string Page = "docs/netcode.md";
    private const int Messages = 1000;
    private const int MostLate = 20;

    public RecipeTests() => LateNetwork.Reset(MostLate, 7);

    public void Dispose()
    {
        UnityEngine.GameObject.DestroyAll();
        global::Unity.Netcode.NetworkManager.All.Clear();
        SystemAPI.World = [];
    }

    [Fact]
    public void With_Mirror_both_peers_have_the_same_ball()
    {
        Type type = DocTests.Recipe(Page, "MirrorBall").GetType("MirrorBall")!;
        var peers = new Mirror.NetworkBehaviour[2];
        for (int i = 0; i < 2; i++)
        {
            peers[i] = Attach<Mirror.NetworkBehaviour>(type);
            peers[i].isServer = i == 0;
            peers[i].netId = (uint)i + 1;
            peers[i].gameObject.WakeUp();
        }

        peers[0].OnStartServer();
        peers[1].OnStartClient();
        Play(peers, () => Array.ForEach(peers, peer => peer.gameObject.Send("FixedUpdate")));
    }

    [Fact]
    public void With_Netcode_for_GameObjects_both_peers_have_the_same_ball()
    {
        Type type = DocTests.Recipe(Page, "NetworkBall").GetType("NetworkBall")!;
        var peers = new global::Unity.Netcode.NetworkBehaviour[2];
        for (int i = 0; i < 2; i++)
        {
            peers[i] = Attach<global::Unity.Netcode.NetworkBehaviour>(type);
            peers[i].NetworkManager = Attach<global::Unity.Netcode.NetworkManager>(typeof(global::Unity.Netcode.NetworkManager));
            peers[i].NetworkManager.LocalClientId = (ulong)i;
            global::Unity.Netcode.NetworkManager.All.Add(peers[i].NetworkManager);
        }

        Array.ForEach(peers, peer => peer.OnNetworkSpawn());
        Play(peers, () => Array.ForEach(peers, peer => peer.NetworkManager.NetworkTickSystem.Advance()));
    }

    /// <summary>FishNet's weaver sends the input of the owner to the server and its state back; the client repeats the inputs since then.</summary>
    [Fact]
    public void With_FishNet_both_peers_have_the_same_ball()
    {
        Assembly recipe = DocTests.Recipe(Page, "FishNetBall");
        Type type = recipe.GetType("FishNetBall")!;
        MethodInfo play = type.GetMethod("Play", BindingFlags.Instance | BindingFlags.NonPublic)!;
        MethodInfo restore = type.GetMethod("Restore", BindingFlags.Instance | BindingFlags.NonPublic)!;
        MethodInfo kick = type.GetMethod("Kick")!;
        FieldInfo next = type.GetField("next", BindingFlags.Instance | BindingFlags.NonPublic)!;
        FishNet.Object.NetworkBehaviour server = Attach<FishNet.Object.NetworkBehaviour>(type);
        FishNet.Object.NetworkBehaviour client = Attach<FishNet.Object.NetworkBehaviour>(type);
        var sent = new SortedDictionary<uint, object>();
        var arrived = new SortedDictionary<uint, object>();
        var random = new Random(3);
        uint done = 0;
        uint restored = 0;
        void Take(FishNet.Object.NetworkBehaviour peer, object input) => play.Invoke(peer, [input, FishNet.Object.Prediction.ReplicateState.Invalid, FishNet.Transporting.Channel.Unreliable]);
        for (uint tick = 1; LateNetwork.Late < 2 * Messages || done < tick; tick++)
        {
            if (LateNetwork.Late < 2 * Messages)
            {
                if (random.Next(4) == 0)
                {
                    kick.Invoke(client, [Random(random, 15), Random(random, 40)]);
                }

                object input = next.GetValue(client)!;
                next.SetValue(client, Activator.CreateInstance(input.GetType()));
                sent.Add(tick, input);
                Take(client, input);
                uint at = tick;
                LateNetwork.Post(() => arrived.Add(at, input));
            }

            while (arrived.TryGetValue(done + 1, out object? input))
            {
                Take(server, input);
                done++;
                uint at = done;
                object data = Activator.CreateInstance(recipe.GetType("BallBytes")!)!;
                byte[] bytes = new byte[Snapshot.Size];
                Snapshot.Write(StateOf(server), bytes);
                data.GetType().GetField("State")!.SetValue(data, bytes);
                ((FishNet.Object.Prediction.IReconcileData)data).SetTick(at);
                LateNetwork.Post(() =>
                {
                    if (at > restored)
                    {
                        restored = at;
                        restore.Invoke(client, [data, FishNet.Transporting.Channel.Unreliable]);
                        foreach (object again in sent.Where(pair => pair.Key > at).Select(pair => pair.Value))
                        {
                            Take(client, again);
                        }
                    }
                });
            }

            LateNetwork.Tick();
            tick -= LateNetwork.Late >= 2 * Messages && done < sent.Count ? 1u : 0;
            if (LateNetwork.Late >= 2 * Messages && done == sent.Count)
            {
                break;
            }
        }

        Settle(() => { });
        server.CreateReconcile();
        Assert.Equal(Snapshot.Hash(StateOf(server)), Snapshot.Hash(StateOf(client)));
        Assert.True(StateOf(server).Position.Length > 1);
    }

    /// <summary>Netcode for Entities restores the ghost fields alone, and predicts the ticks since the snapshot again with the commands of each tick.</summary>
    [Fact]
    public void With_Netcode_for_Entities_both_peers_have_the_same_ball()
    {
        Assembly recipe = DocTests.Recipe(Page, "NetBallSystem");
        Type ball = recipe.GetType("NetBall")!;
        Type command = recipe.GetType("KickCommand")!;
        Type system = recipe.GetType("NetBallSystem")!;
        MethodInfo update = system.GetMethod("OnUpdate", BindingFlags.Instance | BindingFlags.NonPublic)!;
        var worlds = new (object System, Array Ball)[2];
        for (int i = 0; i < 2; i++)
        {
            worlds[i] = (Activator.CreateInstance(system)!, Array.CreateInstance(ball, 1));
        }

        var commands = new Dictionary<uint, Array>();
        void Run(int which, uint tick)
        {
            SystemAPI.World = new()
            {
                [typeof(NetworkTime)] = [new[] { new NetworkTime { ServerTick = new NetworkTick(tick) } }],
                [ball] = [worlds[which].Ball],
                [command] = [commands[tick]],
            };
            update.Invoke(worlds[which].System, null);
        }

        // The client is ahead of the server by as much as a command may be late.
        var random = new Random(5);
        uint newest = 0;
        uint client = 0;
        for (uint server = 1; server <= Messages; server++)
        {
            while (client < server + MostLate)
            {
                client++;
                object given = Activator.CreateInstance(command)!;
                if (random.Next(4) == 0)
                {
                    UnityEngine.Vector3 v = Random(random, 15);
                    command.GetField("Velocity")!.SetValue(given, new global::Unity.Mathematics.float3(v.x, v.y, v.z));
                    command.GetField("Kick")!.SetValue(given, new InputEvent { Count = 1 });
                }

                Array box = Array.CreateInstance(command, 1);
                box.SetValue(given, 0);
                commands.Add(client, box);
                Run(1, client);
            }

            Run(0, server);
            uint at = server;
            object ghost = worlds[0].Ball.GetValue(0)!;
            LateNetwork.Post(() =>
            {
                if (at > newest)
                {
                    // Only ghost fields come back.
                    newest = at;
                    object own = worlds[1].Ball.GetValue(0)!;
                    foreach (FieldInfo field in ball.GetFields().Where(field => field.IsDefined(typeof(GhostFieldAttribute))))
                    {
                        field.SetValue(own, field.GetValue(ghost));
                    }

                    worlds[1].Ball.SetValue(own, 0);
                    for (uint again = at + 1; again <= client; again++)
                    {
                        Run(1, again);
                    }
                }
            });
            LateNetwork.Tick();
        }

        Settle(() => { });
        for (uint tick = Messages + 1; tick <= client; tick++)
        {
            Run(0, tick);
        }

        Assert.Equal(worlds[0].Ball.GetValue(0), worlds[1].Ball.GetValue(0));
        Assert.InRange(LateNetwork.Late, Messages, int.MaxValue);
        Assert.True(((FixedStepRunner)system.GetField("runner", BindingFlags.Instance | BindingFlags.NonPublic)!.GetValue(worlds[0].System)!).State.Position.Length > 1);
    }

    [Fact]
    public void Jobs_step_many_balls_with_the_bits_of_a_loop()
    {
        Assembly recipe = DocTests.Recipe("docs/unity-jobs.md", "ManyBalls");
        Type type = recipe.GetType("ManyBalls")!;
        using var many = (IDisposable)Activator.CreateInstance(type, 200)!;
        var balls = (global::Unity.Collections.NativeArray<BallState>)type.GetProperty("Balls")!.GetValue(many)!;
        var simulator = new Simulator();
        var log = new StepLog();
        BallState alone = balls[123];
        for (int i = 0; i < 300; i++)
        {
            type.GetMethod("Step")!.Invoke(many, null);
            log.Clear();
            simulator.Step(ref alone, 0.01, log);
        }

        Assert.True(Snapshot.Same(alone, balls[123]));
        Assert.NotEqual(balls[0].Position, balls[123].Position);

        // An fp_state of the C library, which the Burst job passes, has the bytes of a BallState.
        Type burst = DocTests.Recipe("docs/unity-jobs.md", "StepBallsInBurst").GetType("StepBallsInBurst")!;
        Assert.True(burst.GetFields().All(field => field.FieldType.IsPrimitive || field.FieldType.IsPointer || field.FieldType == typeof(nint)));
        Assert.Equal(216, Marshal.SizeOf<BallState>());
    }

    private static T Attach<T>(Type type)
        where T : UnityEngine.Component => (T)new UnityEngine.GameObject(type.Name).Attach(type);

    private static UnityEngine.Vector3 Random(Random random, float most) =>
        new(most * ((2f * random.NextSingle()) - 1f), most * 0.5f * random.NextSingle(), most * ((2f * random.NextSingle()) - 1f));

    private static FixedStepRunner RunnerOf(object peer) =>
        (FixedStepRunner)peer.GetType().GetField("runner", BindingFlags.Instance | BindingFlags.NonPublic)!.GetValue(peer)!;

    private static BallState StateOf(object peer) => RunnerOf(peer).State;

    /// <summary>Both peers kick now and then, until enough messages were late; then nobody kicks, and all messages arrive.</summary>
    private static void Play(object[] peers, Action tick)
    {
        MethodInfo kick = peers[0].GetType().GetMethod("Kick")!;
        var random = new Random(11);
        while (LateNetwork.Late < Messages)
        {
            foreach (object peer in peers)
            {
                if (random.Next(6) == 0)
                {
                    kick.Invoke(peer, [UnityFrame.FromUnity(Random(random, 12)), UnityFrame.SpinFromUnity(Random(random, 40))]);
                }
            }

            tick();
            LateNetwork.Tick();
        }

        Settle(tick);
        Assert.Equal(RunnerOf(peers[0]).Tick, RunnerOf(peers[1]).Tick);
        Assert.Equal(Snapshot.Hash(StateOf(peers[0])), Snapshot.Hash(StateOf(peers[1])));
        Assert.True(StateOf(peers[0]).Position.Length > 1);
    }

    private static void Settle(Action tick)
    {
        for (int i = 0; i < 3 * MostLate; i++)
        {
            tick();
            LateNetwork.Tick();
        }
    }
}
