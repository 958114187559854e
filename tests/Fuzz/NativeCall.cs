using System.Reflection;
using System.Reflection.Emit;
using System.Runtime.InteropServices;
using FootballPhysics.Native;

namespace FootballPhysics.Fuzz;

/// <summary>An export of the C interface, called by its address as C calls it.</summary>
/// <param name="Name">The name in C.</param>
/// <param name="Parameters">The parameters.</param>
/// <param name="Result">The type of the result.</param>
/// <param name="Invoke">Calls it; each argument and the result are 64 bits.</param>
internal readonly record struct NativeCall(string Name, ParameterInfo[] Parameters, Type Result, Func<long[], long> Invoke)
{
    /// <summary>
    /// The exports that are not called: a request of a few bytes can make <c>fp_goal_chance</c> simulate for minutes, and <c>fp_check_structs</c> reads no input.
    /// A watch contains addresses of functions, so calls with one are left out too. tests/Native/hostile.c calls all of them.
    /// </summary>
    private static readonly string[] s_others = ["fp_check_structs", "fp_goal_chance"];

    /// <summary>The other exports, in the order of their names.</summary>
    public static NativeCall[] All() =>
    [
        .. typeof(Exports).GetMethods(BindingFlags.Public | BindingFlags.Static)
            .Select(method => (Method: method, method.GetCustomAttribute<UnmanagedCallersOnlyAttribute>()?.EntryPoint))
            .Where(export => export.EntryPoint is not null && !s_others.Contains(export.EntryPoint) && !Array.Exists(export.Method.GetParameters(), at => at.ParameterType == typeof(NativeWatch*)))
            .OrderBy(export => export.EntryPoint, StringComparer.Ordinal)
            .Select(export => new NativeCall(export.EntryPoint!, export.Method.GetParameters(), export.Method.ReturnType, Compiled(export.Method))),
    ];

    private static Func<long[], long> Compiled(MethodInfo method)
    {
        var caller = new DynamicMethod(method.Name, typeof(long), [typeof(long[])], typeof(NativeCall).Module, skipVisibility: true);
        ILGenerator code = caller.GetILGenerator();
        Type[] types = [.. method.GetParameters().Select(parameter => parameter.ParameterType)];
        for (int i = 0; i < types.Length; i++)
        {
            code.Emit(OpCodes.Ldarg_0);
            code.Emit(OpCodes.Ldc_I4, i);
            code.Emit(OpCodes.Ldelem_I8);
            if (types[i] == typeof(double))
            {
                code.Emit(OpCodes.Call, ((Func<long, double>)BitConverter.Int64BitsToDouble).Method);
            }
            else if (types[i] != typeof(long))
            {
                code.Emit(types[i].IsPointer ? OpCodes.Conv_I : OpCodes.Conv_I4);
            }
        }

        code.Emit(OpCodes.Ldc_I8, (long)method.MethodHandle.GetFunctionPointer());
        code.Emit(OpCodes.Conv_I);
        Type result = method.ReturnType;
        code.EmitCalli(OpCodes.Calli, CallingConvention.Cdecl, result.IsEnum ? typeof(int) : Plain(result), [.. types.Select(Plain)]);
        if (method.ReturnType == typeof(double))
        {
            code.Emit(OpCodes.Call, ((Func<double, long>)BitConverter.DoubleToInt64Bits).Method);
        }
        else
        {
            code.Emit(OpCodes.Conv_I8);
        }

        code.Emit(OpCodes.Ret);
        return caller.CreateDelegate<Func<long[], long>>();
    }

    private static Type Plain(Type type) => type.IsPointer ? typeof(nint) : type;
}
