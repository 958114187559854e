using System.Runtime.InteropServices;
using FootballPhysics.Labs.Fuzz;
using FootballPhysics.Native;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Fuzz;

/// <summary>
/// Calls of the C interface, one after the other: each byte sequence is a program. A call returns a status of the header and never "internal"; a rejected call changes nothing and gives
/// a sentence; no call writes beyond its arrays; a ball that the library steps is a ball that it accepts again.
/// </summary>
internal sealed class CallFuzz : FuzzTarget
{
    /// <summary>Calls of one program.</summary>
    private const int MostCalls = 24;

    /// <summary>Attempts to make a call that is not rejected.</summary>
    private const int MostAttempts = 30;

    /// <summary>Scenes that a program may name by their number.</summary>
    private static readonly string[] s_scenes =
    [
        "{}",
        """{"profile":"published","air":{"wind":[3,0,-7]}}""",
        """{"goals":[{"center":[0,0,-11],"facing":[0,0,1]}],"obstacles":[{"name":"wall","shape":"box","center":[0,1,-6],"halfSize":[1,1,0.2]}],"solver":{"integrator":"rk2"}}""",
        """{"bodies":[{"name":"keeper","shape":"capsule","from":[0,0.3,0],"to":[0,1.6,0],"radius":0.3,"mass":75}],"goals":[{"center":[0,0,-11],"facing":[0,0,1]}]}""",
    ];

    /// <summary>Requests of aims and fits.</summary>
    private static readonly string[] s_requests =
    [
        "{}",
        """{"from":[0,0.11,0],"target":[3,1.5,-20],"speed":25}""",
        """{"from":[0,0.11,0],"target":[3,0.11,-20],"speed":12,"method":"direct"}""",
        """{"also":["drag","restitution"]}""",
    ];

    /// <summary>The exports by their names in C, in their order: a byte of a program chooses one.</summary>
    private static readonly NativeCall[] s_calls = NativeCall.All();

    private static readonly NativeCall s_error = Call("fp_last_error");
    private static readonly NativeCall s_free = Call("fp_scene_free");
    private static readonly NativeCall s_freeMatch = Call("fp_match_free");
    private static readonly NativeCall s_freeFilter = Call("fp_filter_free");
    private static readonly NativeCall s_read = Call("fp_read");

    public override string Name => "calls";

    /// <summary>A program of a scene, a launch and a few calls, or of a match; a mutation changes a few bytes.</summary>
    public override byte[] Make(SeededRandom random, int mutations)
    {
        var program = new ProgramBytes([], random);
        var arguments = new CallArguments(program, s_scenes, s_requests);
        string[] match = ["fp_match_create", "fp_match_place", "fp_match_kick", random.Any("fp_match_record", "fp_match_move_bodies"), "fp_match_step", random.Any("fp_match_save", "fp_match_recording")];
        string[] ball = ["fp_scene_create", "fp_launch", random.Any("fp_step", "fp_run_many", "fp_look_ahead", "fp_snapshot_write")];
        foreach (string name in (string[])[.. random.Any(ball, match, [.. ball, .. match]), s_calls[random.Below(s_calls.Length)].Name])
        {
            // Most random arguments are rejected, and calls after a rejected one show little.
            int start = program.Length;
            bool isOk = false;
            for (int attempt = 0; attempt < MostAttempts && !isOk; attempt++)
            {
                program.Shorten(start);
                program.Add((byte)Array.FindIndex(s_calls, call => call.Name == name));
                isOk = Called(program, arguments);
            }
        }

        Free(arguments);
        return FuzzBytes.Changed(random, program.ToArray(), mutations / 2);
    }

    public override bool Try(byte[] input)
    {
        var program = new ProgramBytes(input);
        var arguments = new CallArguments(program, s_scenes, s_requests);
        bool refused = true;
        for (int i = 0; i < MostCalls && !program.IsOver; i++)
        {
            refused &= !Called(program, arguments);
        }

        Free(arguments);
        return refused;
    }

    /// <summary>Reads and makes a call.</summary>
    /// <returns>True if it has a status, which is OK.</returns>
    private static bool Called(ProgramBytes program, CallArguments arguments)
    {
        NativeCall call = s_calls[program.Byte() % s_calls.Length];
        long[] values = arguments.Of(call);
        long result = call.Invoke(values);
        if (call.Result != typeof(NativeStatus))
        {
            Must(call.Result != typeof(double) || double.IsFinite(BitConverter.Int64BitsToDouble(result)), $"{call.Name} returns no number");
            arguments.Check(call, values, isDone: false);
            return false;
        }

        var status = (NativeStatus)result;
        Must(Enum.IsDefined(status) && status != NativeStatus.Internal, $"{call.Name} returns {status}: {Sentence()}");
        Must(status == NativeStatus.Ok || Sentences.Is(Sentence()), $"{call.Name} gives no sentence");
        arguments.Check(call, values, isDone: status is NativeStatus.Ok or NativeStatus.Buffer);
        if (status == NativeStatus.Ok && call.Parameters[0].ParameterType == typeof(NativeScene*))
        {
            foreach (nint ball in arguments.BallsOf(call, values))
            {
                Must((NativeStatus)s_read.Invoke([values[0], ball, CallArguments.Spare]) == NativeStatus.Ok, $"{call.Name} makes a ball that the next call rejects");
            }
        }

        return status == NativeStatus.Ok;
    }

    private static void Free(CallArguments arguments)
    {
        foreach (nint scene in arguments.Scenes)
        {
            s_free.Invoke([scene]);
        }

        foreach (nint match in arguments.Matches)
        {
            s_freeMatch.Invoke([match]);
        }

        foreach (nint filter in arguments.Filters)
        {
            s_freeFilter.Invoke([filter]);
        }
    }

    private static string Sentence() => Marshal.PtrToStringUTF8((nint)s_error.Invoke([])) ?? "";

    private static NativeCall Call(string name) => Array.Find(s_calls, call => call.Name == name);
}
