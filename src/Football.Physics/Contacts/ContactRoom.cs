using System.Collections.Concurrent;

namespace FootballPhysics.Contacts;

/// <summary>Memory for contact sets that exceed the caller's stack memory.</summary>
/// <remarks>
/// Stationary surfaces are never dropped from a set, however many of them a ball touches. The memory is kept, so a later step with as many contacts
/// allocates nothing. Sets in use at the same time need separate memory. Threads that share a simulator each have their own.
/// </remarks>
internal sealed class ContactRoom
{
    private readonly ConcurrentDictionary<int, Contact[]> _contacts = new();

    /// <summary>Returns memory for a number of contacts.</summary>
    /// <param name="count">The number of contacts.</param>
    /// <param name="room">The caller's memory.</param>
    /// <returns>The caller's memory if it is large enough; otherwise, this object's memory.</returns>
    public Span<Contact> Of(int count, Span<Contact> room)
    {
        if (count <= room.Length)
        {
            return room;
        }

        int thread = Environment.CurrentManagedThreadId;
        if (!_contacts.TryGetValue(thread, out Contact[]? contacts) || contacts.Length < count)
        {
            contacts = new Contact[Math.Max(count, 2 * (contacts?.Length ?? 0))];
            _contacts[thread] = contacts;
        }

        return contacts;
    }

    /// <summary>Doubles the memory of a full set, and copies its contacts.</summary>
    public Span<Contact> Grown(Span<Contact> full)
    {
        Span<Contact> grown = Of(2 * full.Length, default);
        full.CopyTo(grown);
        return grown;
    }
}
