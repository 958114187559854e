using System;
using System.Collections;
using System.Collections.Generic;
using Unity.Entities;

namespace Unity.Mathematics
{
    public struct float3
    {
        public float x;
        public float y;
        public float z;

        public float3(float x, float y, float z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }
    }
}

namespace Unity.Entities
{
    public interface IComponentData
    {
    }

    [AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct)]
    public sealed class UpdateInGroupAttribute : Attribute
    {
        public UpdateInGroupAttribute(Type groupType) => GroupType = groupType;

        public Type GroupType { get; }
    }

    public abstract class ComponentSystemGroup
    {
    }

    public abstract class SystemBase
    {
        protected abstract void OnUpdate();
    }

    /// <summary>A component of an entity; in the shim a box that the test holds.</summary>
    public readonly struct RefRW<T>
        where T : struct, IComponentData
    {
        private readonly T[] _box;

        public RefRW(T[] box) => _box = box;

        public ref T ValueRW => ref _box[0];

        public ref readonly T ValueRO => ref _box[0];
    }

    public readonly struct RefRO<T>
        where T : struct, IComponentData
    {
        private readonly T[] _box;

        public RefRO(T[] box) => _box = box;

        public ref readonly T ValueRO => ref _box[0];
    }

    public readonly struct QueryEnumerable<T> : IEnumerable<T>
    {
        private readonly IEnumerable<T> _all;

        public QueryEnumerable(IEnumerable<T> all) => _all = all;

        public QueryEnumerable<T> WithAll<TComponent>() => this;

        public IEnumerator<T> GetEnumerator() => _all.GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
    }

    /// <summary>In the shim the world that a test has set: boxes of components by type.</summary>
    public static class SystemAPI
    {
        /// <summary>The components of the world that is updated now: by type, a list of boxes (arrays of length 1).</summary>
        public static Dictionary<Type, List<Array>> World { get; set; } = new Dictionary<Type, List<Array>>();

        public static T GetSingleton<T>()
            where T : struct, IComponentData => ((T[])World[typeof(T)][0])[0];

        public static QueryEnumerable<T> Query<T>()
        {
            Type component = typeof(T).GetGenericArguments()[0];
            var all = new List<T>();
            foreach (Array box in World[component])
            {
                all.Add((T)Activator.CreateInstance(typeof(T), box)!);
            }

            return new QueryEnumerable<T>(all);
        }
    }
}

namespace Unity.NetCode
{
    public enum GhostPrefabType
    {
        None = 0,
        InterpolatedClient = 1,
        PredictedClient = 2,
        Client = 3,
        Server = 4,
        AllPredicted = 6,
        All = 7,
    }

    [AttributeUsage(AttributeTargets.Struct)]
    public sealed class GhostComponentAttribute : Attribute
    {
        public GhostPrefabType PrefabType { get; set; }
    }

    [AttributeUsage(AttributeTargets.Field)]
    public sealed class GhostFieldAttribute : Attribute
    {
    }

    public sealed class PredictedSimulationSystemGroup : ComponentSystemGroup
    {
    }

    public struct Simulate : IComponentData
    {
    }

    public struct NetworkTick
    {
        public NetworkTick(uint value) => TickIndexForValidTick = value;

        public uint TickIndexForValidTick { get; }
    }

    public struct NetworkTime : IComponentData
    {
        public NetworkTick ServerTick;

        public bool IsPartialTick { get; set; }
    }

    public interface IInputComponentData : IComponentData
    {
    }

    /// <summary>Set in exactly the tick for which a player gave the input, also when that tick is predicted again.</summary>
    public struct InputEvent
    {
        public uint Count;

        public readonly bool IsSet => Count > 0;

        public void Set() => Count++;
    }
}
