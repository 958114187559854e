using System;

namespace Unity.Collections
{
    public enum Allocator
    {
        Invalid = 0,
        None = 1,
        Temp = 2,
        TempJob = 3,
        Persistent = 4,
    }

    /// <summary>Of unmanaged values alone, as in the engine.</summary>
    public struct NativeArray<T> : IDisposable
        where T : struct
    {
        internal readonly T[] Items;

        public NativeArray(int length, Allocator allocator) => Items = new T[length];

        public readonly int Length => Items.Length;

        public T this[int index]
        {
            readonly get => Items[index];
            set => Items[index] = value;
        }

        public readonly void Dispose()
        {
        }
    }
}

namespace Unity.Collections.LowLevel.Unsafe
{
    [AttributeUsage(AttributeTargets.Field)]
    public sealed class NativeDisableUnsafePtrRestrictionAttribute : Attribute
    {
    }

    public static class NativeArrayUnsafeUtility
    {
        public static unsafe void* GetUnsafePtr<T>(this NativeArray<T> nativeArray)
            where T : unmanaged
        {
            var handle = System.Runtime.InteropServices.GCHandle.Alloc(nativeArray.Items, System.Runtime.InteropServices.GCHandleType.Pinned);
            return (void*)handle.AddrOfPinnedObject(); // a test keeps it pinned
        }
    }
}

namespace Unity.Burst
{
    [AttributeUsage(AttributeTargets.Struct)]
    public sealed class BurstCompileAttribute : Attribute
    {
    }
}

namespace Unity.Jobs
{
    public struct JobHandle
    {
        public readonly void Complete()
        {
        }
    }

    public interface IJobParallelFor
    {
        void Execute(int index);
    }

    public interface IJob
    {
        void Execute();
    }

    /// <summary>In the shim jobs run on the threads of the pool, within Schedule.</summary>
    public static class JobExtensions
    {
        public static JobHandle Schedule<T>(this T jobData, int arrayLength, int innerloopBatchCount, JobHandle dependsOn = default)
            where T : struct, IJobParallelFor
        {
            if (System.Runtime.CompilerServices.RuntimeHelpers.IsReferenceOrContainsReferences<T>() && !IsArrayAlone(typeof(T)))
            {
                throw new InvalidOperationException($"{typeof(T)} contains a managed field. A job has none.");
            }

            System.Threading.Tasks.Parallel.For(0, arrayLength, index => jobData.Execute(index));
            return default;
        }

        public static JobHandle Schedule<T>(this T jobData, JobHandle dependsOn = default)
            where T : struct, IJob
        {
            jobData.Execute();
            return default;
        }

        /// <summary>The shim's arrays are managed; the engine's are not.</summary>
        private static bool IsArrayAlone(Type type) => Array.TrueForAll(
            type.GetFields(System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.Public | System.Reflection.BindingFlags.NonPublic),
            field => !field.FieldType.IsClass || field.FieldType.IsPointer);
    }
}
